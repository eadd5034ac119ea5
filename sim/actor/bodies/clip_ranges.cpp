#include "sim/actor/bodies/clip_ranges.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "sim/actor/anatomy/clip_turns.h"
#include "sim/actor/anatomy/name_pattern.h"
#include "sim/actor/bodies/joint_ranges.h"
#include "sim/actor/clips/body_clip.h"
#include "sim/actor/clips/clip_overlaps.h"
#include "sim/actor/limbs/mirror.h"

namespace knuckle {

namespace {

uint32_t boneOf(const Model& model, const std::string& name)
{
    const auto bone = std::ranges::find(model.bones, name, &Bone::name);
    return bone == model.bones.end() ? NO_INDEX : static_cast<uint32_t>(bone - model.bones.begin());
}

/// Per joint the one on the other side, NO_INDEX for none.
std::vector<uint32_t> oppositeJoints(const Model& model, const std::optional<Mirror>& mirror, const Actor& actor)
{
    std::vector<uint32_t> opposite(actor.joints.size(), NO_INDEX);
    for (uint32_t j = 0; mirror && j < actor.joints.size(); ++j) {
        const uint32_t bone = boneOf(model, actor.joints[j].name);
        const uint32_t image = bone == NO_INDEX ? NO_INDEX : mirror->images[bone];
        if (image == NO_INDEX) continue;
        const auto other = std::ranges::find(actor.joints, model.bones[image].name, &ActorJoint::name);
        if (other != actor.joints.end() && other->type == actor.joints[j].type)
            opposite[j] = static_cast<uint32_t>(other - actor.joints.begin());
    }
    return opposite;
}

}  // namespace

void takeInClips(const Model& model, const ArticulationOptions& options, Actor& actor)
{
    if (model.clips.empty() || actor.joints.empty()) return;
    const std::optional<Mirror> mirror = findMirror(BoneTree(model));
    const std::vector<uint32_t> opposite = oppositeJoints(model, mirror, actor);
    std::vector<BodyClip> clips;
    for (const Clip& clip : model.clips) clips.push_back(ownClip(actor, model, clip).clip);
    for (uint32_t j = 0; j < actor.joints.size(); ++j) {
        ActorJoint& joint = actor.joints[j];
        if (!joint.limits.any() || findByPattern(options.limits, joint.name)) continue;
        std::vector<Turns> turns;
        for (const BodyClip& clip : clips) {
            turns.push_back(turnsOf(clip, joint.child));
            if (opposite[j] == NO_INDEX) continue;
            const Turns others = turnsOf(clip, actor.joints[opposite[j]].child);
            turns.push_back(mirrored(others, mirror->plane.across));
        }
        // A turn about the limb is measured from the middle of its cone, so that comes first.
        for (const Turns& clip : turns)
            if (joint.type == JointType::Ball) leanTo(joint.limits, joint.axis, clip);
        for (const Turns& clip : turns) takeIn(joint.limits, joint.type, joint.axis, clip);
    }
}

void takeIn(Actor& actor, const BodyClip& clip)
{
    for (ActorJoint& joint : actor.joints) {
        const JointType type = joint.type == JointType::Universal ? JointType::Hinge : joint.type;
        takeIn(joint.limits, type, joint.axis, turnsOf(clip, joint.child));
    }
    for (const auto& pair : overlapsIn(actor, clip)) actor.passes.push_back(pair);
}

}  // namespace knuckle
