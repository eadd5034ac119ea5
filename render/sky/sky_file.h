#pragma once

#include <string>

#include "render/sky/sky_map.h"

namespace knuckle {

/// A picture of everything around, once around from left to right and from straight up to straight down: PNG, JPEG or
/// OpenEXR. @throws InputError of one line if it cannot be read or is not twice as wide as high.
SkyMap readSky(const std::string& path);

}  // namespace knuckle
