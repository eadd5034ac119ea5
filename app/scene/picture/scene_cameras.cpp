#include "app/scene/picture/scene_cameras.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/json/fields.h"
#include "app/scene/picture/name_pattern.h"

namespace knuckle {

namespace {

constexpr const char* AUTOMATIC = "auto";
constexpr size_t NAMES_TOLD = 12;

std::vector<std::string> shortened(std::vector<std::string> names)
{
    names.resize(std::min(names.size(), NAMES_TOLD));
    return names;
}

template <typename Map>
std::vector<std::string> namesOf(const Map& map)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : map) names.push_back(name);
    return names;
}

/// Reads one camera of a scene.
class CameraReader {
public:
    CameraReader(const JsonFile& file, const World& world, const NamedParticles& particles)
        : file_(file), world_(world), particles_(particles)
    {
    }

    CameraSettings read(const Json& json, const std::string& pointer) const
    {
        CameraSettings camera = readFields<CameraSettings>(json);
        camera.shake = readFields<CameraShake>(json["shake"]);
        if (camera.kind == CameraKind::Follow) follow(camera, pointer);
        else if (!camera.follow.empty())
            fail(pointer + "/follow", "is given beside a `kind` that follows nothing; take one of them away");
        attend(camera, json, pointer);
        focusOn(camera, json["focusOn"], pointer);
        readKeys(camera, json["keys"], pointer + "/keys");
        if (camera.kind != CameraKind::Fixed && !camera.keys.empty())
            fail(pointer + "/keys", "are for a camera of kind \"fixed\"; take one of them away");
        return camera;
    }

private:
    [[noreturn]] void fail(const std::string& pointer, const std::string& message) const
    {
        failAt(file_.path, pointer, message);
    }

    void follow(CameraSettings& camera, const std::string& pointer) const
    {
        std::vector<std::string> names;
        for (const Object& object : world_.objects) names.push_back(object.name);
        if (names.empty()) fail(pointer + "/kind", "\"follow\" needs an object with a body; take \"fixed\"");
        if (camera.follow.empty()) camera.follow = names.front();
        if (std::ranges::find(names, camera.follow) != names.end()) return;
        fail(pointer + "/follow",
             fmt::format("there is no object \"{}\"; {}", camera.follow, suggestion(camera.follow, shortened(names))));
    }

    void attend(CameraSettings& camera, const Json& json, const std::string& pointer) const
    {
        for (const auto& [field, attention] :
             {std::pair{"frame", CameraAttention::Frame}, std::pair{"lookAt", CameraAttention::LookAt}}) {
            const Json& patterns = json[field];
            const std::string where = fmt::format("{}/{}", pointer, field);
            if (patterns.empty()) continue;
            if (camera.attention != CameraAttention::None)
                fail(where, "is given beside `frame`, which turns the camera as well; take one of them away");
            if (camera.kind == CameraKind::Follow)
                fail(where, "is given beside the kind \"follow\", which looks at its object; take one of them away");
            camera.attention = attention;
            for (size_t i = 0; i < patterns.size(); ++i) addNamed(camera.named, patterns[i], where, i);
        }
        if (camera.attention == CameraAttention::LookAt && camera.automatic)
            fail(pointer + "/automatic", "must be false with `lookAt`: give a position, or `frame` instead");
    }

    void focusOn(CameraSettings& camera, const Json& patterns, const std::string& pointer) const
    {
        for (size_t i = 0; i < patterns.size(); ++i) addNamed(camera.focused, patterns[i], pointer + "/focusOn", i);
        if (!patterns.empty() && camera.focus > 0.0f)
            fail(pointer + "/focusOn",
                 "is given beside `focus`, which says what is sharp as well; take one of them away");
    }

    void addNamed(std::vector<ParticleRange>& named, const std::string& pattern, const std::string& where,
                  size_t index) const
    {
        const size_t before = named.size();
        for (const auto& [name, ranges] : particles_)
            if (fits(name, pattern)) named.insert(named.end(), ranges.begin(), ranges.end());
        if (named.size() > before) return;
        fail(fmt::format("{}/{}", where, index), fmt::format("there is no object \"{}\"; {}", pattern,
                                                             suggestion(pattern, shortened(namesOf(particles_)))));
    }

    void readKeys(CameraSettings& camera, const Json& json, const std::string& pointer) const
    {
        CameraKey key{.position = camera.position,
                      .target = camera.target,
                      .fieldOfView = camera.fieldOfView,
                      .roll = camera.roll,
                      .aperture = camera.aperture,
                      .focus = camera.focus};
        for (size_t i = 0; i < json.size(); ++i) {
            const auto read = [&](const char* field, auto& value) {
                if (json[i].contains(field)) readValue(json[i][field], value);
            };
            read("time", key.time);
            read("position", key.position);
            read("target", key.target);
            read("fieldOfView", key.fieldOfView);
            read("roll", key.roll);
            read("aperture", key.aperture);
            read("focus", key.focus);
            read("easing", key.easing);
            const std::string where = fmt::format("{}/{}", pointer, i);
            if (!camera.keys.empty() && key.time <= camera.keys.back().time)
                fail(where + "/time", "must be after that of the key before");
            if (camera.attention != CameraAttention::LookAt && (key.position - key.target).norm() < 1e-6f)
                fail(where, "has the camera where it looks; move `position` or `target`");
            if (!camera.keys.empty() && (key.focus > 0.0f) != (camera.keys.front().focus > 0.0f))
                fail(where + "/focus", "has a distance at some keys only; give `focus` in all keys, or in the camera");
            if (key.focus > 0.0f && !camera.focused.empty())
                fail(where + "/focus", "is given beside `focusOn`; take one of them away");
            camera.keys.push_back(key);
        }
    }

    const JsonFile& file_;
    const World& world_;
    const NamedParticles& particles_;
};

using Cameras = std::map<std::string, CameraSettings>;

/// @param cameras  With those that every scene has.
const CameraSettings& namedCamera(const JsonFile& file, const Cameras& cameras, const std::string& name,
                                  const std::string& pointer)
{
    if (const auto found = cameras.find(name); found != cameras.end()) return found->second;
    const bool hasOwn = !file.root["cameras"].empty();
    const std::string remedy = hasOwn ? suggestion(name, shortened(namesOf(cameras))) : "add it to `cameras`";
    failAt(file.path, pointer, fmt::format("there is no camera \"{}\"; {}", name, remedy));
}

Cameras ofEveryScene(const JsonFile& file)
{
    CameraSettings turntable;
    turntable.kind = CameraKind::Orbit;
    turntable.orbitSpeed = 360.0f / file.root["duration"].get<float>();
    return {{AUTOMATIC, CameraSettings{}}, {TURNTABLE, turntable}};
}

/// With those that every scene has.
Cameras readNamed(const JsonFile& file, const CameraReader& reader)
{
    Cameras cameras = ofEveryScene(file);
    for (const auto& [name, json] : file.root["cameras"].items()) {
        const std::string pointer = "/cameras/" + name;
        if (name.empty() || name == AUTOMATIC || name == TURNTABLE || name.find('=') != std::string::npos)
            failAt(file.path, pointer, fmt::format("\"{}\" is no name for a camera; choose another one", name));
        cameras[name] = reader.read(json, pointer);
    }
    return cameras;
}

/// The cameras of a shot.
void chooseCameras(const JsonFile& file, const Cameras& cameras, const Json& json, const std::string& pointer,
                   Shot& shot)
{
    const auto named = [&](const char* field, CameraSettings& camera) {
        const std::string name = json[field];
        if (!name.empty()) camera = namedCamera(file, cameras, name, fmt::format("{}/{}", pointer, field));
        return !name.empty();
    };
    named("camera", shot.camera);
    readValue(json["insetAt"], shot.insetAt);
    if (named("inset", shot.other)) shot.layout = PictureLayout::Inset;
    if (!named("beside", shot.other)) return;
    if (shot.layout == PictureLayout::Inset)
        failAt(file.path, pointer + "/beside", "is given beside `inset`; take one of them away");
    shot.layout = PictureLayout::Beside;
}

}  // namespace

void readCameras(const JsonFile& file, const World& world, const NamedParticles& particles, RenderSettings& render)
{
    const CameraReader reader(file, world, particles);
    render.camera = reader.read(file.root["camera"], "/camera");
    render.cameras = readNamed(file, reader);
    const Json& shots = file.root["shots"];
    for (size_t i = 0; i < shots.size(); ++i) {
        const std::string pointer = fmt::format("/shots/{}", i);
        Shot shot{.from = shots[i]["from"], .timeScale = shots[i]["timeScale"], .camera = render.camera};
        if (i == 0 && shot.from != 0.0) failAt(file.path, pointer + "/from", "must be 0: the film begins with it");
        if (i > 0 && shot.from <= render.shots.back().from)
            failAt(file.path, pointer + "/from", "must be after that of the shot before");
        chooseCameras(file, render.cameras, shots[i], pointer, shot);
        render.shots.push_back(std::move(shot));
    }
    const std::string only = file.root["render"]["camera"];
    if (only.empty()) return;
    namedCamera(file, render.cameras, only, "/render/camera");
    render = filmedBy(render, only);
}

}  // namespace knuckle
