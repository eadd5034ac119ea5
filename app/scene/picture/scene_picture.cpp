#include "app/scene/picture/scene_picture.h"

#include "app/json/fields.h"

namespace knuckle {

RenderSettings readPicture(const JsonFile& file, const World& world, const NamedParticles& particles)
{
    RenderSettings render = readFields<RenderSettings>(file.root["render"]);
    render.light = readFields<LightSettings>(file.root["light"]);
    if (render.light.direction.norm() < 1e-6f) failAt(file.path, "/light/direction", "must not be zero");
    readCameras(file, world, particles, render);
    return render;
}

}  // namespace knuckle
