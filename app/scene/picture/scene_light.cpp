#include "app/scene/picture/scene_light.h"

#include <fmt/format.h>

#include "app/json/fields.h"
#include "render/sky/clear_sky.h"

namespace knuckle {

namespace {

constexpr float SHORTEST = 1e-6f;  // of a direction

/// @returns whether the document has the field.
bool readIfGiven(const Json& json, const char* key, Eigen::Vector3f& out)
{
    if (!json.contains(key)) return false;
    readValue(json[key], out);
    return true;
}

void makeClear(const JsonFile& file, LightSettings& light)
{
    const Eigen::Vector3f sun = light.direction.normalized();
    if (sun.y() <= 0.0f)
        failAt(file.path, "/light/direction",
               "has a sun below the horizon, and the sky is \"clear\"; give it a y above 0");
    const ClearSky sky(sun, file.root["light"]["turbidity"].get<double>());
    light.sky = std::make_shared<const SkyMap>(sky.map());
    light.color = sky.sunColor();
    light.skyColor = light.sky->meanOf(true);
    light.groundColor = light.sky->meanOf(false);
}

/// A file, or a word that is misspelt.
std::string skyPicture(const JsonFile& file, const std::string& sky, SceneFiles& files)
{
    const std::vector<std::string> words{"clear", "gradient"};
    if (sky.find('.') == std::string::npos && !nearestWord(sky, words).empty())
        failAt(file.path, "/light/sky", fmt::format("\"{}\" is unknown; {}", sky, suggestion(sky, words)));
    return files.existing(sky, "/light/sky");
}

}  // namespace

LightSettings readLight(const JsonFile& file, SceneFiles& files)
{
    const Json& json = file.root["light"];
    LightSettings light = readFields<LightSettings>(json);
    if (light.direction.norm() < SHORTEST) failAt(file.path, "/light/direction", "must not be zero");
    const std::string sky = json["sky"];
    if (sky == "clear") makeClear(file, light);
    else if (sky != "gradient") light.skyFile = skyPicture(file, sky, files);
    readIfGiven(json, "color", light.color);
    light.takesSkyColor = !readIfGiven(json, "skyColor", light.skyColor) && !light.skyFile.empty();
    light.takesGroundColor = !readIfGiven(json, "groundColor", light.groundColor) && !light.skyFile.empty();
    return light;
}

std::vector<LightSource> readLights(const JsonFile& file)
{
    std::vector<LightSource> lights;
    for (const Json& json : file.root["lights"]) {
        LightSource light{.isPoint = json["type"] == "point"};
        readValue(json[light.isPoint ? "position" : "direction"], light.place);
        readValue(json["color"], light.color);
        readValue(json["intensity"], light.intensity);
        if (!light.isPoint && light.place.norm() < SHORTEST)
            failAt(file.path, fmt::format("/lights/{}/direction", lights.size()), "must not be zero");
        lights.push_back(light);
    }
    return lights;
}

}  // namespace knuckle
