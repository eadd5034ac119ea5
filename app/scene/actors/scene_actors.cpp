#include "app/scene/actors/scene_actors.h"

#include <fmt/format.h>

#include "app/json/joint_limits.h"
#include "app/scene/actors/scene_animation.h"
#include "app/scene/actors/scene_bodies.h"
#include "app/scene/actors/scene_drive.h"
#include "app/scene/actors/scene_releases.h"
#include "app/scene/actors/scene_skins.h"
#include "app/scene/scene_limits.h"

namespace knuckle {

namespace {

/// Indices of an actor's bodies that the scene holds.
std::vector<uint32_t> heldBodies(const ObjectEntry& entry, const Actor& actor)
{
    std::vector<uint32_t> held;
    if (entry.json["fixed"].get<bool>())
        for (uint32_t b = 0; b < actor.bodies.size(); ++b) held.push_back(b);
    const Json& wanted = entry.json["hold"];
    for (size_t i = 0; i < wanted.size(); ++i)
        held.push_back(bodyNamed(entry, actor, wanted[i], fmt::format("/hold/{}", i)));
    return held;
}

/// Two held bodies make a loop, which needs joints without limits: removes those of all held bodies except the first.
void freeHeldJoints(Actor& actor, const std::vector<uint32_t>& held)
{
    for (ActorJoint& joint : actor.joints)
        for (size_t i = 1; i < held.size(); ++i)
            if (joint.child == held[i] || joint.parent == held[i]) joint.limits = {};
}

}  // namespace

void addActors(const ObjectEntry& entry)
{
    Actor actor = entry.actor();
    limitParticles(entry, static_cast<double>(actor.particles.size()));
    const JointStrength strength = readStrength(entry.json);
    for (ActorJoint& joint : actor.joints)
        if (!joint.strength.tears()) joint.strength = strength;
    const std::vector<uint32_t> held = heldBodies(entry, actor);
    freeHeldJoints(actor, held);
    const bool animated = isAnimated(entry.json);
    if (animated && !held.empty()) entry.fail("/animation", "is for what is not held; take `fixed` and `hold` away");
    PlayedClips clips;
    if (animated) {
        clips = readClips(entry, actor);
        allow(actor, clips.needs);
    }
    std::vector<uint32_t> objects;
    WorldBuilder& builder = entry.context.builder;
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        actor.name = entry.copyName(copy);
        objects.push_back(addActor(builder, actor, entry.material, entry.poses[copy], entry.velocity));
        for (const uint32_t body : held) builder.holdBody(builder.world().objects[objects.back()].bodyStart + body);
    }
    entry.context.actors.push_back({std::make_shared<const Actor>(actor), objects});
    if (animated) animateActors(entry, actor, objects, clips.plays);
    driveActors(entry, actor, objects);
    releaseActors(entry, actor, objects);
    if (showsSkin(entry.json)) wearSkin(entry, actor, objects);
}

}  // namespace knuckle
