#include "app/film/scene_sky.h"

#include <fmt/format.h>

#include "app/json/json.h"
#include "render/sky/sky_file.h"
#include "sim/base/errors.h"

namespace knuckle {

void readSkyOf(Scene& scene)
{
    LightSettings& light = scene.render.light;
    if (light.skyFile.empty()) return;
    try {
        light.sky = std::make_shared<const SkyMap>(readSky(light.skyFile));
    } catch (const InputError& error) {
        failAt(scene.file, "/light/sky",
               fmt::format("{}; take another picture, \"clear\" or \"gradient\"", error.what()));
    }
    if (light.takesSkyColor) light.skyColor = light.sky->meanOf(true);
    if (light.takesGroundColor) light.groundColor = light.sky->meanOf(false);
}

}  // namespace knuckle
