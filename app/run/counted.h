#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace knuckle {

/// "1 joint", "12 joints". `many`: if it is not `one` with an s.
inline std::string counted(uint64_t count, const std::string& one, const std::string& many = {})
{
    return fmt::format("{} {}", count, count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace knuckle
