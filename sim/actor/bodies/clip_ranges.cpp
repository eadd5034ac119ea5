#include "sim/actor/bodies/clip_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/actor/anatomy/clip_turns.h"
#include "sim/actor/anatomy/name_pattern.h"
#include "sim/actor/bodies/joint_ranges.h"
#include "sim/actor/bodies/short_list.h"
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

/// Tells which hinges clips turn farther than their limits go.
void noteLeftOut(const Actor& actor, const std::vector<float>& farthest, std::vector<std::string>& notes)
{
    std::vector<std::string> joints;
    for (size_t j = 0; j < farthest.size(); ++j)
        if (farthest[j] != 0.0f)
            joints.push_back(fmt::format("{} by {:.0f} degrees", actor.joints[j].name,
                                         std::abs(farthest[j]) * 180.0f / std::numbers::pi_v<float>));
    if (!joints.empty())
        notes.push_back(fmt::format("Clips turn joints beyond what a body's do, for a moment or by far, which their "
                                    "limits do not take in: {}.",
                                    shortList(joints)));
}

}  // namespace

void takeInClips(const Model& model, const ArticulationOptions& options, Actor& actor)
{
    if (model.clips.empty() || actor.joints.empty()) return;
    const std::optional<Mirror> mirror = findMirror(BoneTree(model));
    const std::vector<uint32_t> opposite = oppositeJoints(model, mirror, actor);
    std::vector<BodyClip> clips;
    for (const Clip& clip : model.clips) clips.push_back(ownClip(actor, model, clip).clip);
    std::vector<float> farthest(actor.joints.size(), 0.0f);
    for (uint32_t j = 0; j < actor.joints.size(); ++j) {
        ActorJoint& joint = actor.joints[j];
        if (!joint.limits.any() || findByPattern(options.limits, joint.name)) continue;
        std::vector<Turns> turns;
        const auto add = [&](Turns clip, float rate) {
            const bool bends = joint.type == JointType::Hinge && joint.limits.bend.bounded();
            turns.push_back(bends ? lastingTurns(joint.limits.bend, joint.axis, clip, rate, farthest[j])
                                  : std::move(clip));
        };
        for (const BodyClip& clip : clips) {
            add(turnsOf(clip, joint.child), clip.rate);
            if (opposite[j] == NO_INDEX) continue;
            const Turns others = turnsOf(clip, actor.joints[opposite[j]].child);
            add(mirrored(others, mirror->plane.across), clip.rate);
        }
        // A turn about the limb is measured from the middle of its cone, so that comes first.
        for (const Turns& clip : turns)
            if (joint.type == JointType::Ball) leanTo(joint.limits, joint.axis, clip);
        for (const Turns& clip : turns) takeIn(joint.limits, joint.type, joint.axis, clip);
    }
    noteLeftOut(actor, farthest, actor.notes);
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
