#include "app/film/complete_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/json/json.h"
#include "render/looks/picture_looks.h"
#include "render/panes/layout.h"
#include "render/sky/sky_file.h"
#include "render/view/framed_sets.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

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

void requireDrawable(const Scene& scene)
{
    try {
        planPanes(scene.render);
        checkTransparency(scene.world, scene.render);
        const std::vector<Shot> shots = shotsOf(scene.render);
        camerasOf(shots, scene.world, float(scene.render.width) / float(scene.render.height));
        framedSets(shots, scene.world);
    } catch (const InputError& error) {
        const std::string message = error.what();  // "render.samples: ..."
        const size_t end = message.find(": ");
        if (end == std::string::npos) throw;
        std::string pointer = "/" + message.substr(0, end);
        std::ranges::replace(pointer, '.', '/');
        failAt(scene.file, pointer, message.substr(end + 2));
    }
}

}  // namespace

void completePicture(Scene& scene)
{
    readSkyOf(scene);
    requireDrawable(scene);
}

}  // namespace knuckle
