#include "render/sky/sky_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/reader/picture_file.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// More columns than this no picture of a film shows apart.
constexpr uint32_t LARGEST_WIDTH = 2048;

}  // namespace

SkyMap readSky(const std::string& path)
{
    const Picture picture = readPicture(path);
    if (picture.width != 2 * picture.height)
        throw InputError(fmt::format("{} has {} x {} pixels; a sky is twice as wide as high (equirectangular)", path,
                                     picture.width, picture.height));
    SkyMap map{picture.width, picture.height, {}};
    for (size_t i = 0; i < picture.pixelCount(); ++i) {
        const auto light = [&](size_t k) { return std::max(decodeSrgb(picture.rgba[4 * i + k]), 0.0f); };
        map.radiance.emplace_back(light(0), light(1), light(2));
    }
    while (map.width > LARGEST_WIDTH) map = halved(map);
    return map;
}

}  // namespace knuckle
