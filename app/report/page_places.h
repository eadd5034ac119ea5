#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace knuckle {

/// Calls write() with the parts of a page, and in place of each {{word}} the function of that name. What that writes is
/// not looked at again.
void fillPage(std::string_view page, const std::map<std::string_view, std::function<void()>>& values,
              const std::function<void(std::string_view)>& write);

/// The page with texts in place of each {{word}}.
std::string filledPage(std::string_view page, const std::map<std::string_view, std::string>& values);

}  // namespace knuckle
