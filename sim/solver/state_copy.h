#pragma once

#include <map>
#include <string>

#include "sim/gpu/buffer_table.h"

namespace knuckle {

/// A copy, on the device, of all buffers of a table that are state: to go back to.
class StateCopy {
public:
    bool empty() const { return copies_.empty(); }
    void take(const BufferTable& table);
    /// Needs buffers of the same sizes as when it was taken.
    void restore(const BufferTable& table) const;

private:
    std::map<std::string, RawBuffer> copies_;
};

}  // namespace knuckle
