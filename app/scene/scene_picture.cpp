#include "app/scene/scene_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/json/fields.h"

namespace knuckle {

RenderSettings readPicture(const JsonFile& file, const World& world)
{
    RenderSettings render = readFields<RenderSettings>(file.root["render"]);
    render.camera = readFields<CameraSettings>(file.root["camera"]);
    render.light = readFields<LightSettings>(file.root["light"]);
    if (render.light.direction.norm() < 1e-6f) failAt(file.path, "/light/direction", "must not be zero");
    if (render.camera.kind != CameraKind::Follow) return render;
    std::string& follow = render.camera.follow;
    std::vector<std::string> names;
    for (const Object& object : world.objects) names.push_back(object.name);
    if (names.empty()) failAt(file.path, "/camera/kind", "\"follow\" needs an object with a body; take \"fixed\"");
    if (follow.empty()) follow = names.front();
    if (std::find(names.begin(), names.end(), follow) != names.end()) return render;
    if (names.size() > 12) names.resize(12);
    failAt(file.path, "/camera/follow",
           fmt::format("there is no object \"{}\"; {}", follow, suggestion(follow, names)));
}

}  // namespace knuckle
