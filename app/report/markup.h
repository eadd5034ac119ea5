#pragma once

#include <string>
#include <string_view>

namespace knuckle {

/// Any bytes as text of HTML or XML, or as the value of an attribute in double or single quotes: valid UTF-8 in which
/// nothing begins a tag or an entity, and without the characters that XML has not.
std::string escapedMarkup(std::string_view text);

}  // namespace knuckle
