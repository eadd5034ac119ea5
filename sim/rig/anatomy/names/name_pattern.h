#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

namespace knuckle {

/// Whether a name matches the pattern: `*` stands for any letters, or none, and `?` for any one.
bool matchesPattern(std::string_view name, std::string_view pattern);

/// The entry for a name: the one of exactly this name, else the longest pattern that matches it, of equally long ones
/// the first in order; nullptr for none.
template <typename Value>
const Value* findByPattern(const std::map<std::string, Value>& entries, const std::string& name)
{
    if (const auto exact = entries.find(name); exact != entries.end()) return &exact->second;
    const Value* found = nullptr;
    size_t longest = 0;
    for (const auto& [pattern, value] : entries) {
        const auto letters = pattern.size() - static_cast<size_t>(std::ranges::count(pattern, '*'));
        if (!matchesPattern(name, pattern) || (found && letters <= longest)) continue;
        found = &value;
        longest = letters;
    }
    return found;
}

}  // namespace knuckle
