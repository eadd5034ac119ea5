#include "app/scene/picture/scene_picture.h"

#include <fmt/format.h>

#include "app/json/fields.h"
#include "app/scene/picture/scene_light.h"
#include "render/settings.h"

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

void readColorScale(const JsonFile& file, RenderSettings& render)
{
    const Json& scale = file.root["render"]["colorScale"];
    if (scale.is_string()) return;
    render.colorScale = Eigen::Vector2f(scale[0].get<float>(), scale[1].get<float>());
    if (!(render.colorScale->x() < render.colorScale->y()))
        failAt(file.path, "/render/colorScale", "its high end must be above its low one");
}

OverlaySettings readOverlay(const JsonFile& file)
{
    OverlaySettings overlay;
    const Json &render = file.root["render"], &captions = file.root["captions"];
    readValue(render["title"], overlay.title);
    for (const Json& label : render["labels"]) {
        overlay.frame = overlay.frame || label == "frame";
        overlay.time = overlay.time || label == "time";
        overlay.scaleBar = overlay.scaleBar || label == "scaleBar";
        overlay.colorBar = overlay.colorBar || label == "colorBar";
    }
    for (size_t k = 0; k < captions.size(); ++k) {
        const Caption& caption = overlay.captions.emplace_back(readFields<Caption>(captions[k]));
        if (caption.to != 0.0f && caption.to <= caption.from)
            failAt(file.path, fmt::format("/captions/{}/to", k), "must be after `from`");
    }
    readValue(file.root["fps"], overlay.framesPerSecond);
    return overlay;
}

}  // namespace

RenderSettings readPicture(const JsonFile& file, const World& world, const NamedParticles& particles, SceneFiles& files)
{
    RenderSettings render = readFields<RenderSettings>(file.root["render"]);
    readFog(file.root["render"]["fog"], render.fog);
    render.light = readLight(file, files);
    render.lights = readLights(file);
    readColorScale(file, render);
    render.overlay = readOverlay(file);
    if (render.overlay.colorBar && !showsQuantity(render))
        failAt(file.path, "/render/labels", "\"colorBar\" needs a render.colorBy that shows a number, as \"speed\"");
    if (render.colorBy == ColorBy::ContactForce && world.settings.solver == SolverKind::Paper)
        failAt(file.path, "/render/colorBy",
               "the paper's solver moves particles and has no forces of contacts; choose another, or the solver "
               "\"default\"");
    readBackground(file.root["render"]["background"], render);
    readCameras(file, world, particles, render);
    return render;
}

}  // namespace knuckle
