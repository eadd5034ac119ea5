#pragma once

#include <string_view>

namespace knuckle {

/// Whether a name fits a pattern, in which * stands for any letters or none.
inline bool fits(std::string_view name, std::string_view pattern)
{
    const size_t star = pattern.find('*');
    if (star == std::string_view::npos) return name == pattern;
    if (!name.starts_with(pattern.substr(0, star))) return false;
    const std::string_view rest = pattern.substr(star + 1);
    for (size_t from = star; from <= name.size(); ++from)
        if (fits(name.substr(from), rest)) return true;
    return false;
}

}  // namespace knuckle
