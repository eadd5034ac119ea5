#include "app/scene/picture/scene_picture.h"

#include "app/json/fields.h"
#include "app/scene/picture/scene_light.h"

namespace knuckle {

namespace {

void readBackground(const Json& json, RenderSettings& render)
{
    if (json.is_string()) {
        render.background = json == "transparent" ? Background::Transparent : Background::Sky;
        return;
    }
    render.background = Background::Color;
    readValue(json, render.backgroundColor);
}

void readFog(const Json& json, FogSettings& fog)
{
    readValue(json["density"], fog.density);
    readValue(json["color"], fog.color);
    readValue(json["falloff"], fog.falloff);
}

}  // namespace

RenderSettings readPicture(const JsonFile& file, const World& world, const NamedParticles& particles, SceneFiles& files)
{
    RenderSettings render = readFields<RenderSettings>(file.root["render"]);
    readFog(file.root["render"]["fog"], render.fog);
    render.light = readLight(file, files);
    render.lights = readLights(file);
    readBackground(file.root["render"]["background"], render);
    readCameras(file, world, particles, render);
    return render;
}

}  // namespace knuckle
