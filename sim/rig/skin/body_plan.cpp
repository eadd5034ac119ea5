#include "sim/rig/skin/body_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/rig/skin/skin_mesh.h"

namespace knuckle {

BodyPlan planOf(const Actor& actor, const Model& model)
{
    BodyPlan plan;
    std::vector<uint32_t> boneOf(actor.bodies.size(), NO_INDEX);
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        const auto body = std::ranges::find(actor.bodies, model.bones[b].name, &ActorBody::name);
        if (body != actor.bodies.end()) boneOf[static_cast<size_t>(body - actor.bodies.begin())] = b;
    }
    plan.above.resize(model.bones.size(), NO_INDEX);
    // A model without bones is one body, whatever the resolution.
    for (const uint32_t body : model.bones.empty() ? std::vector<uint32_t>() : bodiesOfBones(actor, model))
        plan.owners.push_back(boneOf[body]);
    for (uint32_t body = 0; body < actor.bodies.size(); ++body) {
        const int32_t parent = parentBody(actor, body);
        if (parent >= 0 && boneOf[body] != NO_INDEX) plan.above[boneOf[body]] = boneOf[static_cast<size_t>(parent)];
    }
    return plan;
}

std::string differenceOf(const Actor& first, const Actor& other)
{
    const auto nameOf = [](const Actor& actor, int32_t body) {
        return body < 0 ? "nothing" : actor.bodies[static_cast<size_t>(body)].name;
    };
    if (first.bodies.size() != other.bodies.size() || first.joints.size() != other.joints.size())
        return fmt::format("it has {} bodies and {} joints instead of {} and {}", other.bodies.size(),
                           other.joints.size(), first.bodies.size(), first.joints.size());
    for (size_t b = 0; b < first.bodies.size(); ++b) {
        const ActorBody &one = first.bodies[b], &two = other.bodies[b];
        if (one.name != two.name || one.parent != two.parent)
            return fmt::format("{} hangs on {} there, {} on {} here", one.name, nameOf(first, one.parent), two.name,
                               nameOf(other, two.parent));
    }
    for (size_t j = 0; j < first.joints.size(); ++j) {
        const ActorJoint &one = first.joints[j], &two = other.joints[j];
        if (one.type != two.type || one.parent != two.parent || one.child != two.child)
            return fmt::format("the joint of {} is of another type or place", one.name);
    }
    return {};
}

}  // namespace knuckle
