#include "app/scene/names/named.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/json/json.h"
#include "app/scene/joints/scene_joints.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

std::vector<uint32_t> bodiesOf(const Object& object)
{
    std::vector<uint32_t> bodies;
    for (uint32_t b = object.bodyStart; b < object.bodyEnd(); ++b) bodies.push_back(b);
    return bodies;
}

[[noreturn]] void failUnknown(const std::string& what, const std::string& name, const std::vector<std::string>& known)
{
    if (known.empty()) throw InputError(fmt::format("there is no {} \"{}\", nor any other", what, name));
    throw InputError(fmt::format("there is no {} \"{}\"; {}", what, name, suggestion(name, known)));
}

}  // namespace

std::optional<Named> looseNamed(const World& world, const std::string& name)
{
    for (const LooseGroup& group : world.looseGroups)
        if (group.name == name) return Named{{}, group.first, group.end};
    for (const SoftBody& soft : world.softBodies)
        if (soft.object != NO_INDEX && world.objects[soft.object].name == name)
            return Named{{}, soft.particleStart, soft.particleStart + soft.particleCount};
    return {};
}

Named named(const World& world, const std::string& name)
{
    std::vector<std::string> known;
    for (const Object& object : world.objects) {
        if (object.bodyCount == 0) continue;
        if (object.name == name) return {bodiesOf(object)};
        known.push_back(object.name);
    }
    if (const std::optional<Named> loose = looseNamed(world, name)) return *loose;
    for (const LooseGroup& group : world.looseGroups) known.push_back(group.name);
    for (const SoftBody& soft : world.softBodies)
        if (soft.object != NO_INDEX) known.push_back(world.objects[soft.object].name);
    for (uint32_t b = 0; b < world.bodies.size(); ++b)
        if (world.bodies[b].object != NO_INDEX && nameInScene(world, world.bodies[b]) == name) return {{b}};
    failUnknown("object or body", name, known);
}

std::vector<uint32_t> bodiesNamed(const World& world, const std::string& name)
{
    Named found = named(world, name);
    if (found.isLoose()) throw InputError(fmt::format("\"{}\" consists of loose particles and has no bodies", name));
    return std::move(found.bodies);
}

uint32_t drivenJointNamed(const World& world, const std::string& name)
{
    std::vector<std::string> known;
    for (uint32_t j = 0; j < world.joints.size(); ++j) {
        if (!world.joints[j].drive.acts()) continue;
        if (world.joints[j].name == name) return j;
        known.push_back(world.joints[j].name);
    }
    failUnknown("joint with a motor or a spring", name, known);
}

std::vector<uint32_t> withHanging(const World& world, const std::vector<uint32_t>& bodies)
{
    std::vector<uint32_t> all = bodies;
    const auto has = [&](uint32_t body) { return std::ranges::find(all, body) != all.end(); };
    for (bool grows = true; grows;) {
        grows = false;
        for (const Joint& joint : world.joints) {
            const bool isSame = world.bodies[joint.parent].object == world.bodies[joint.child].object;
            if (!isSame || !has(joint.parent) || has(joint.child)) continue;
            all.push_back(joint.child);
            grows = true;
        }
    }
    std::ranges::sort(all);
    return all;
}

}  // namespace knuckle
