#pragma once

#include <map>
#include <string>

#include "sim/gpu/buffer_table.h"

namespace knuckle {

/// A copy, on the device, of all buffers of a table that are state, for going back to it.
class StateCopy {
public:
    bool empty() const { return copies_.empty(); }
    void take(const BufferTable& table);
    /// Buffers must have the same sizes as when the copy was taken.
    void restore(const BufferTable& table) const;

private:
    std::map<std::string, RawBuffer> copies_;
};

}  // namespace knuckle
