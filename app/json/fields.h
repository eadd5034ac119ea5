#pragma once

#include <array>
#include <limits>
#include <string>

#include "app/json/enum_words.h"
#include "app/json/json.h"
#include "render/settings.h"
#include "sim/world/world.h"

/// Maps JSON fields to struct members, in one place for both directions: read() takes a struct from a document that its
/// schema has completed, write() is the inverse.
namespace knuckle {

template <typename T>
std::string wordOf(T value)
{
    return EnumWords<T>::WORDS.at(static_cast<size_t>(value));
}

/// A number for which 0 means infinity.
inline float readUnlessZero(const Json& json)
{
    const float value = json;
    return value != 0.0f ? value : std::numeric_limits<float>::infinity();
}

/// The enum's value for a word that the schema has already accepted.
template <typename T>
T valueOf(const std::string& word)
{
    size_t index = 0;
    while (EnumWords<T>::WORDS.at(index) != word) ++index;
    return static_cast<T>(index);
}

inline void readValue(const Json& json, Eigen::Vector3f& out)
{
    out = {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

template <typename T>
void readValue(const Json& json, T& out)
{
    if constexpr (std::is_enum_v<T>) {
        out = valueOf<T>(json.get<std::string>());
    } else {
        out = json.get<T>();
    }
}

inline Json writeValue(const Eigen::Vector3f& value)
{
    return Json::array({value.x(), value.y(), value.z()});
}

template <typename T>
Json writeValue(const T& value)
{
    if constexpr (std::is_enum_v<T>) {
        return wordOf(value);
    } else {
        return value;
    }
}

template <typename Visitor>
void visitFields(Settings& s, Visitor&& visit)
{
    visit("method", s.solver);
    visit("rotation", s.rotation);
    visit("grid", s.grid);
    visit("reduction", s.reduction);
    visit("velocityOrder", s.velocityOrder);
    visit("gravity", s.gravity);
    visit("timeStep", s.timeStep);
    visit("substeps", s.substeps);
    visit("iterations", s.iterations);
    visit("stabilization", s.stabilization);
    visit("contactMargin", s.contactMargin);
    visit("freeze", s.freeze);
    visit("virtualParticles", s.virtualParticles);
    visit("splitSharedMass", s.splitSharedMass);
    visit("linearDamping", s.linearDamping);
    visit("maxSpeed", s.maxSpeed);
    visit("massScaling", s.massScaling);
    visit("vorticity", s.vorticity);
    visit("sleep", s.sleepSpeed);
}

template <typename Visitor>
void visitFields(Material& m, Visitor&& visit)
{
    visit("density", m.density);
    visit("staticFriction", m.staticFriction);
    visit("kineticFriction", m.kineticFriction);
    visit("restitution", m.restitution);
    visit("rollingFriction", m.rollingFriction);
    visit("fluid", m.fluid);
    visit("viscosity", m.viscosity);
    visit("slip", m.slip);
    visit("surfaceTension", m.surfaceTension);
    visit("color", m.color);
    visit("draw", m.look.drawn);
    visit("absorption", m.look.absorption);
    visit("scattering", m.look.scattering);
    visit("foam", m.look.foam);
    visit("stiffness", m.elasticity.stiffness);
    visit("poissonRatio", m.elasticity.poissonRatio);
    visit("damping", m.elasticity.damping);
    visit("yield", m.elasticity.yield);
    visit("creep", m.elasticity.creep);
    visit("maxDeformation", m.elasticity.maxDeformation);
    visit("finish", m.finish.word);
    visit("emission", m.finish.emission);
}

template <typename Visitor>
void visitFields(Wind& w, Visitor&& visit)
{
    visit("velocity", w.velocity);
    visit("density", w.density);
    visit("gusts", w.gusts);
    visit("gustSize", w.gustSize);
    visit("seed", w.seed);
}

/// All except the region and the end.
template <typename Visitor>
void visitFields(ForceField& f, Visitor&& visit)
{
    visit("kind", f.kind);
    visit("falloff", f.falloff);
    visit("strength", f.strength);
    visit("start", f.start);
}

/// Fields of every shape of collider; the shapes' own fields are in app/scene/colliders/scene_colliders.cpp.
template <typename Visitor>
void visitFields(Collider& c, Visitor&& visit)
{
    visit("position", c.position);
    visit("staticFriction", c.staticFriction);
    visit("kineticFriction", c.kineticFriction);
    visit("color", c.color);
    visit("visible", c.visible);
    visit("finish", c.finish.word);
    visit("emission", c.finish.emission);
}

/// All except keys, shake and whom it frames, looks at or has sharp.
template <typename Visitor>
void visitFields(CameraSettings& c, Visitor&& visit)
{
    visit("kind", c.kind);
    visit("automatic", c.automatic);
    visit("position", c.position);
    visit("target", c.target);
    visit("fieldOfView", c.fieldOfView);
    visit("roll", c.roll);
    visit("orbitSpeed", c.orbitSpeed);
    visit("follow", c.follow);
    visit("fill", c.fill);
    visit("aperture", c.aperture);
    visit("focus", c.focus);
}

template <typename Visitor>
void visitFields(CameraShake& s, Visitor&& visit)
{
    visit("amplitude", s.amplitude);
    visit("frequency", s.frequency);
    visit("seed", s.seed);
}

/// All except the sky and colours, which may come from it.
template <typename Visitor>
void visitFields(LightSettings& l, Visitor&& visit)
{
    visit("direction", l.direction);
    visit("intensity", l.intensity);
    visit("softness", l.softness);
    visit("bounce", l.bounce);
}

template <typename Visitor>
void visitFields(Caption& c, Visitor&& visit)
{
    visit("text", c.text);
    visit("from", c.from);
    visit("to", c.to);
    visit("at", c.at);
    visit("size", c.size);
}

/// Camera and lights are separate documents in a scene; without the background, fog, the scale of colours and labels.
template <typename Visitor>
void visitFields(RenderSettings& r, Visitor&& visit)
{
    visit("width", r.width);
    visit("height", r.height);
    visit("colorBy", r.colorBy);
    visit("highlightJoints", r.highlightJoints);
    visit("speedScale", r.speedScale);
    visit("palette", r.palette);
    visit("skinError", r.skinError);
    visit("exposure", r.exposure);
    visit("toneMap", r.toneMap);
    visit("antialiasing", r.antialiasing);
    visit("quality", r.quality);
    visit("samples", r.samples);
    visit("shutter", r.shutter);
    visit("bloom", r.bloom);
    visit("vignette", r.vignette);
}

template <typename T>
T readFields(const Json& json)
{
    T out;
    visitFields(out, [&](const char* key, auto& field) { readValue(json.at(key), field); });
    return out;
}

/// What a finish has of its own, where a document says so.
inline void readFinish(const Json& json, SurfaceFinish& finish)
{
    if (json.contains("roughness")) readValue(json["roughness"], finish.roughness);
    if (json.contains("metalness")) readValue(json["metalness"], finish.metalness);
}

template <typename T>
Json writeFields(T value)
{
    Json out = Json::object();
    visitFields(value, [&](const char* key, auto& field) { out[key] = writeValue(field); });
    return out;
}

}  // namespace knuckle
