#include "sim/base/fnv_hash.h"

#include <fmt/format.h>

namespace knuckle {

std::string hashText(uint64_t hash)
{
    return fmt::format("{:016x}", hash);
}

}  // namespace knuckle
