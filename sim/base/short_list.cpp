#include "sim/base/short_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace knuckle {

std::string shortList(std::span<const std::string> names, size_t most)
{
    if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", fmt::join(names.first(most - 1), ", "), names.size() - (most - 1));
}

}  // namespace knuckle
