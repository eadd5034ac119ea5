#include "app/files/actor_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>

#include "app/files/actor_check.h"
#include "app/files/actor_mass.h"
#include "app/files/npz/actor_arrays.h"
#include "app/files/robot/robot.h"
#include "app/files/skin_text.h"
#include "app/json/fields.h"
#include "app/json/joint_limits.h"
#include "app/json/json.h"
#include "app/json/list_text.h"
#include "app/schema/schema.h"
#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

constexpr int ACTOR_VERSION = 1;
constexpr const char* ACTOR_FORMAT = "knuckle-actor";
constexpr const char* NPZ = ".npz";

const Schema& actorSchema()
{
    static const Schema schema("actor.schema.json");
    return schema;
}

std::string stringText(const std::string& text)
{
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string massText(const ActorMass& body)
{
    const auto row = [&](int k) { return vectorText(body.inertia.row(k)); };
    return fmt::format("\"mass\": {}, \"centre\": {}, \"inertia\": [{}, {}, {}]", body.mass, vectorText(body.centre),
                       row(0), row(1), row(2));
}

std::string bodyText(const ActorBody& body, const ActorMass& mass)
{
    std::vector<std::string> merged;
    for (const std::string& bone : body.mergedBones) merged.push_back(stringText(bone));
    return fmt::format("{{ \"name\": {}, \"parent\": {}, {}{}, \"mergedBones\": [{}], \"particles\": [{}] }}",
                       stringText(body.name), body.parent, body.isCross ? "\"cross\": true, " : "", massText(mass),
                       fmt::join(merged, ", "), fmt::join(body.particles, ", "));
}

std::string jointText(const ActorJoint& joint)
{
    const std::string limits = joint.limits.any() ? ", \"limits\": " + writeLimits(joint.limits).dump() : "";
    const auto tearing = [](const char* field, float most) {
        return std::isinf(most) ? "" : fmt::format(", \"{}\": {}", field, most);
    };
    return fmt::format("{{ \"name\": {}, \"type\": \"{}\", \"parent\": {}, \"child\": {}, \"anchor\": {}, "
                       "\"axis\": {}, \"sharedParticles\": [{}]{}{}{} }}",
                       stringText(joint.name), wordOf(joint.type), joint.parent, joint.child, vectorText(joint.anchor),
                       vectorText(joint.axis), fmt::join(joint.sharedParticles, ", "), limits,
                       tearing("tearForce", joint.strength.force), tearing("tearTorque", joint.strength.torque));
}

void checkIndices(const JsonFile& file, const std::string& pointer, const std::vector<uint32_t>& indices, size_t count,
                  const char* of)
{
    for (size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] < count) continue;
        failAt(file.path, fmt::format("{}/{}", pointer, i),
               fmt::format("{} is not one of the {} {}", indices[i], count, of));
    }
}

ActorBody readBody(const JsonFile& file, const Json& json, size_t index, size_t particleCount)
{
    const std::string pointer = fmt::format("/bodies/{}", index);
    ActorBody body;
    readValue(json["name"], body.name);
    readValue(json["parent"], body.parent);
    readValue(json["particles"], body.particles);
    readValue(json["mergedBones"], body.mergedBones);
    readValue(json["cross"], body.isCross);
    checkIndices(file, pointer + "/particles", body.particles, particleCount, "particles");
    if (body.parent >= static_cast<int64_t>(index)) {
        failAt(file.path, pointer + "/parent",
               fmt::format("{} must be smaller than the body's own place, {}", body.parent, index));
    }
    return body;
}

ActorJoint readJoint(const JsonFile& file, const Json& json, size_t index, const Actor& actor)
{
    const std::string pointer = fmt::format("/joints/{}", index);
    ActorJoint joint;
    readValue(json["name"], joint.name);
    readValue(json["type"], joint.type);
    readValue(json["parent"], joint.parent);
    readValue(json["child"], joint.child);
    readValue(json["anchor"], joint.anchor);
    readValue(json["axis"], joint.axis);
    readValue(json["sharedParticles"], joint.sharedParticles);
    joint.limits = readWrittenLimits(json["limits"]);
    joint.strength = readStrength(json);
    // A universal joint is stored as its two hinges.
    const JointType type = joint.type == JointType::Universal ? JointType::Hinge : joint.type;
    requireLimits(file.path, pointer + "/limits", joint.limits, {type});
    checkIndices(file, pointer + "/sharedParticles", joint.sharedParticles, actor.particles.size(), "particles");
    for (const auto& [key, body] : {std::pair{"parent", joint.parent}, std::pair{"child", joint.child}}) {
        if (body < actor.bodies.size()) continue;
        failAt(file.path, fmt::format("{}/{}", pointer, key),
               fmt::format("{} is not one of the {} bodies", body, actor.bodies.size()));
    }
    if (joint.type == JointType::Universal && actor.bodies[joint.parent].isCross == actor.bodies[joint.child].isCross)
        failAt(file.path, pointer,
               "a universal joint is two, to and from a body with `cross`: true; make the actor anew "
               "with knuckle voxelize");
    return joint;
}

/// Pairs of bodies, each with the smaller index first.
std::vector<std::array<uint32_t, 2>> readPairs(const JsonFile& file, size_t bodyCount)
{
    std::vector<std::array<uint32_t, 2>> pairs;
    std::map<std::array<uint32_t, 2>, size_t> places;
    for (const Json& entry : file.root["neverTouch"]) {
        const std::string pointer = fmt::format("/neverTouch/{}", pairs.size());
        std::vector<uint32_t> bodies;
        readValue(entry, bodies);
        checkIndices(file, pointer, bodies, bodyCount, "bodies");
        const auto [lower, upper] = std::ranges::minmax(bodies);
        if (lower == upper)
            failAt(file.path, pointer, fmt::format("names body {} twice; name another one, or remove the pair", lower));
        pairs.push_back({lower, upper});
        const auto [first, isNew] = places.try_emplace(pairs.back(), pairs.size() - 1);
        if (!isNew)
            failAt(file.path, pointer, fmt::format("is the pair of /neverTouch/{} again; remove one", first->second));
    }
    return pairs;
}

constexpr std::array<const char*, 3> CENTERINGS{"never", "whereFar", "always"};  // in the order of Centering

std::string sourceText(const ModelSource& model)
{
    if (model.file.empty()) return {};
    std::string text = fmt::format(",\n  \"model\": {}", stringText(model.file));
    if (!model.pick.skeleton.empty()) text += fmt::format(",\n  \"skeleton\": {}", stringText(model.pick.skeleton));
    if (model.pick.split) text += ",\n  \"split\": true";
    const ModelFit& fit = model.fit;
    if (fit.scale != 0.0) text += fmt::format(",\n  \"scale\": {}", fit.scale);
    if (fit.height != 0.0) text += fmt::format(",\n  \"height\": {}", fit.height);
    if (fit.up == UpAxis::Z) text += ",\n  \"up\": \"z\"";
    if (fit.centering != Centering::Never)
        text += fmt::format(",\n  \"centering\": \"{}\"", CENTERINGS[static_cast<size_t>(fit.centering)]);
    return text;
}

ModelSource readSource(const Json& root)
{
    ModelSource model;
    readValue(root["model"], model.file);
    readValue(root["skeleton"], model.pick.skeleton);
    readValue(root["split"], model.pick.split);
    readValue(root["scale"], model.fit.scale);
    readValue(root["height"], model.fit.height);
    if (root["up"] == "z") model.fit.up = UpAxis::Z;
    const auto centering = std::ranges::find(CENTERINGS, root["centering"].get<std::string>());
    model.fit.centering = static_cast<Centering>(centering - CENTERINGS.begin());
    return model;
}

}  // namespace

std::string actorText(const Actor& actor)
{
    std::string text = fmt::format("{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"name\": {},\n"
                                   "  \"diameter\": {}",
                                   ACTOR_FORMAT, ACTOR_VERSION, stringText(actor.name), actor.diameter);
    text += sourceText(actor.model);
    const std::vector<ActorMass> masses = massesOf(actor);
    const auto bodyOf = [&](const ActorBody& body) {
        return bodyText(body, masses[static_cast<size_t>(&body - actor.bodies.data())]);
    };
    text += "," + listText("bodies", actor.bodies, bodyOf);
    text += "," + listText("joints", actor.joints, jointText);
    const auto pairText = [](const auto& pair) { return fmt::format("[{}]", fmt::join(pair, ", ")); };
    if (!actor.filtered.empty()) text += "," + listText("neverTouch", actor.filtered, pairText);
    text += "," + listText("notes", actor.notes, stringText);
    text += "," + listText("particles", actor.particles, vectorText);
    text += "," + listText("outward", actor.outward, vectorText);
    std::vector<std::string> distances;
    for (const float distance : actor.signedDistances) distances.push_back(numberText(distance));
    text += fmt::format(",\n  \"signedDistances\": [{}]", fmt::join(distances, ", "));
    if (!actor.skin.empty()) text += "," + skinText(actor.skin);
    return text + "\n}\n";
}

/// As a file of that ending has it.
std::string bytesOf(const Actor& actor, const std::string& ending)
{
    if (ending == ".urdf") return urdfOf(robotOf(actor));
    if (ending == ".mjcf") return mjcfOf(robotOf(actor));
    return ending == NPZ ? npzText(actor) : actorText(actor);
}

void writeActor(OutputFile& file, const std::string& path, const Actor& actor)
{
    namespace fs = std::filesystem;
    Actor placed = actor;
    // A stream has no folder: uses the program's own, if it still exists.
    std::error_code gone;
    const fs::path folder = file.isStream() ? fs::current_path(gone) : fs::absolute(path, gone).parent_path();
    if (std::string& model = placed.model.file; !model.empty() && !gone)
        model = fs::absolute(model, gone).lexically_proximate(folder).generic_string();
    file.write(bytesOf(placed, endingOf(path)));
    file.commit();
}

void writeActor(const std::string& path, const Actor& actor)
{
    requireEnding("", path, "an actor", actorEndings());
    OutputFile file(path);
    writeActor(file, path, actor);
}

std::string npzText(const Actor& actor)
{
    JsonFile file{actor.name, Json::parse(actorText(actor))};
    actorSchema().complete(file);
    return zipOf(arraysOf(file.root));
}

const std::vector<const char*>& actorEndings()
{
    static const std::vector<const char*> ENDINGS{".json", NPZ, ".urdf", ".mjcf"};
    return ENDINGS;
}

bool isActorName(const std::string& path)
{
    return endingOf(path) == ".json" || endingOf(path) == NPZ;
}

bool isActorFile(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    if (endingOf(path) == NPZ) return true;
    const Json root = readJsonFile(path).root;
    return root.is_object() && root.contains("format") && root["format"] == ACTOR_FORMAT;
}

Actor readActor(const std::string& path)
{
    const bool isArchive = endingOf(path) == NPZ;
    return actorOf(isArchive ? JsonFile{path, documentOf(readZip(readInput(path, "an actor"), path), path)}
                             : readJsonFile(path));
}

Actor actorOf(JsonFile file)
{
    actorSchema().complete(file);
    const std::string& path = file.path;
    const Json& root = file.root;
    Actor actor;
    readValue(root["name"], actor.name);
    readValue(root["diameter"], actor.diameter);
    readValue(root["signedDistances"], actor.signedDistances);
    readValue(root["notes"], actor.notes);
    actor.model = readSource(root);
    if (std::string& model = actor.model.file; !model.empty())
        model = (std::filesystem::path(path).parent_path() / model).lexically_normal().string();
    for (const Json& position : root["particles"]) readValue(position, actor.particles.emplace_back());
    for (const Json& direction : root["outward"]) readValue(direction, actor.outward.emplace_back());
    for (const Json& body : root["bodies"]) {
        actor.bodies.push_back(readBody(file, body, actor.bodies.size(), actor.particles.size()));
    }
    for (const Json& joint : root["joints"]) {
        actor.joints.push_back(readJoint(file, joint, actor.joints.size(), actor));
    }
    actor.filtered = readPairs(file, actor.bodies.size());
    requireConsistent(path, actor);
    requireMasses(path, root, actor);
    actor.skin = readSkin(path, root, actor);
    return actor;
}

}  // namespace knuckle
