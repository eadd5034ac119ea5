#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/gpu/buffer_table.h"

namespace knuckle {

/// Copies, on the device, of what buffers held in the frame before.
class EarlierBuffers {
public:
    /// Adds the copy of "places" to the table as "earlierPlaces". @param buffer must outlive it, at its place.
    template <typename T>
    void add(BufferTable& table, const Buffer<T>& buffer)
    {
        std::string label = buffer.label();
        label[0] = static_cast<char>(label[0] - 'a' + 'A');
        const auto copy = std::make_shared<Buffer<T>>("earlier" + label, buffer.size());
        table.add(Lifetime::Scratch, *copy);
        copies_.emplace_back(&buffer, copy);
    }
    /// At the end of a frame.
    void take()
    {
        for (const auto& [buffer, copy] : copies_) copy->copy(*buffer, buffer->bytes());
    }

private:
    std::vector<std::pair<const RawBuffer*, std::shared_ptr<RawBuffer>>> copies_;
};

}  // namespace knuckle
