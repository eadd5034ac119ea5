#pragma once

#include <string>

namespace knuckle {

/// The page that shows a live scene. @param name of the scene, for its title.
std::string livePage(const std::string& name);

}  // namespace knuckle
