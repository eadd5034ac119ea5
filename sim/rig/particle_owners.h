#pragma once

#include <cstdint>
#include <vector>

namespace knuckle {

struct Actor;

/// Per particle, the body that it is added with: of those that share it the one with the fewest particles, which may
/// have no others; NO_INDEX without a body.
std::vector<uint32_t> particleOwners(const Actor& actor);

}  // namespace knuckle
