#include "sim/solver/state_copy.h"

namespace knuckle {

void StateCopy::take(const BufferTable& table)
{
    for (const auto& [name, entry] : table.entries()) {
        if (entry.lifetime != Lifetime::State) continue;
        RawBuffer& copy = copies_[name];
        if (copy.id() == 0 || copy.bytes() != entry.buffer->bytes())
            copy = RawBuffer(name + " kept", entry.buffer->bytes());
        copy.copy(*entry.buffer, copy.bytes());
    }
}

void StateCopy::restore(const BufferTable& table) const
{
    for (const auto& [name, copy] : copies_) table.find(name, "the kept state").buffer->copy(copy, copy.bytes());
}

}  // namespace knuckle
