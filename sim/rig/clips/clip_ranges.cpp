#include "sim/rig/clips/clip_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/angles.h"
#include "sim/base/short_list.h"
#include "sim/rig/anatomy/clip_turns.h"
#include "sim/rig/anatomy/names/name_pattern.h"
#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/clip_overlaps.h"
#include "sim/rig/joints/joint_ranges.h"
#include "sim/rig/joints/lasting_turns.h"

namespace knuckle {

namespace {

/// The bone that the joint is named after; NO_INDEX for none.
uint32_t boneOf(const Model& model, const std::string& name)
{
    const auto bone = std::ranges::find(model.bones, name, &Bone::name);
    return bone == model.bones.end() ? NO_INDEX : static_cast<uint32_t>(bone - model.bones.begin());
}

/// Per joint the one on the other side, NO_INDEX for none.
std::vector<uint32_t> oppositeJoints(const Figure& figure, const Actor& actor)
{
    const Model& model = figure.model;
    const std::optional<Mirror>& mirror = figure.mirror;
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

/// Lists the joints that turn beyond their limits, and how far: "forearm.L by 81 degrees".
/// @param leftOut per joint [rad]. @returns empty if there are none.
std::string farJoints(const Actor& actor, const std::vector<float>& leftOut)
{
    std::vector<std::string> joints;
    for (size_t j = 0; j < leftOut.size(); ++j)
        if (leftOut[j] > 0.0f)
            joints.push_back(fmt::format("{} by {:.0f} degrees", actor.joints[j].name, degreesOf(leftOut[j])));
    return joints.empty() ? "" : shortList(joints);
}

/// Per joint, how far clips may go beyond its limits.
std::vector<Leeway> leeways(const Figure& figure, const Actor& actor)
{
    std::vector<Leeway> leeways;
    for (const ActorJoint& joint : actor.joints) {
        const uint32_t bone = boneOf(figure.model, joint.name);
        using enum BodyPart;
        constexpr std::array NO_PERSONS{Other, Hips, Tail, Wing, Coxa, Lever};
        const bool known = figure.upright && bone != NO_INDEX &&
                           std::ranges::count(NO_PERSONS, figure.anatomy[bone].part) == 0;
        leeways.push_back(known ? Leeway() : GUESSED);
    }
    return leeways;
}

/// A universal joint's halves are hinges.
JointType halfType(JointType type)
{
    return type == JointType::Universal ? JointType::Hinge : type;
}

/// The limits that needsOf() makes from lasting turns.
JointLimits widened(const ActorJoint& joint, const LastingTurns& lasting)
{
    JointLimits limits = joint.limits;
    for (const Turns& part : lasting.parts) takeIn(limits, halfType(joint.type), joint.axis, part);
    return limits;
}

/// Puts a body's turns into a clip, with neighbours in time on the same side of the sphere.
void putTurns(BodyClip& clip, uint32_t body, const Turns& turns)
{
    for (size_t key = 0; key < turns.size(); ++key) {
        Quaternionf& turn = clip.turns[key * clip.bodyCount + body];
        turn = turns[key];
        if (key > 0 && turn.dot(clip.turns[(key - 1) * clip.bodyCount + body]) < 0.0f) turn.coeffs() = -turn.coeffs();
    }
}

}  // namespace

ClipNeeds rangesInClips(const Figure& figure, const Actor& actor, const ArticulationOptions& options)
{
    ClipNeeds needs;
    for (const ActorJoint& joint : actor.joints) needs.limits.push_back(joint.limits);
    if (figure.model.clips.empty() || actor.joints.empty()) return needs;
    const std::vector<uint32_t> opposite = oppositeJoints(figure, actor);
    const std::vector<Leeway> leeway = leeways(figure, actor);
    std::vector<BodyClip> clips;
    for (const Clip& clip : figure.model.clips) clips.push_back(ownClip(actor, figure.model, clip).clip);
    std::vector<float> leftOut(actor.joints.size(), 0.0f);
    for (uint32_t j = 0; j < actor.joints.size(); ++j) {
        const ActorJoint& joint = actor.joints[j];
        const bool hasRange = joint.type == JointType::Hinge || joint.type == JointType::Ball;
        if (!hasRange || !joint.limits.any() || findByPattern(options.limits, joint.name)) continue;
        std::vector<Turns> turns;
        const auto add = [&](const Turns& clip, float rate, float& most) {
            LastingTurns lasting = lastingTurns(joint.limits, joint.type, joint.axis, clip, rate, leeway[j]);
            most = std::max(most, lasting.leftOut);
            for (Turns& part : lasting.parts) turns.push_back(std::move(part));
        };
        float elsewhere = 0.0f;  // what the other side leaves out is noted there
        for (const BodyClip& clip : clips) {
            add(turnsOf(clip, joint.child), clip.rate, leftOut[j]);
            if (opposite[j] == NO_INDEX) continue;
            const Turns others = turnsOf(clip, actor.joints[opposite[j]].child);
            add(mirrored(others, figure.mirror->plane.across), clip.rate, elsewhere);
        }
        // A turn about the limb is measured from the middle of its cone, so the cone comes first.
        for (const Turns& clip : turns)
            if (joint.type == JointType::Ball) leanTo(needs.limits[j], joint.axis, clip);
        for (const Turns& clip : turns) takeIn(needs.limits[j], joint.type, joint.axis, clip);
    }
    if (const std::string joints = farJoints(actor, leftOut); !joints.empty())
        needs.notes.push_back(
            "Clips turn joints beyond what a body's do, for a moment or by far, which their limits do "
            "not take in: " +
            joints + ".");
    return needs;
}

std::string holdWithinLimits(const Actor& actor, BodyClip& clip)
{
    std::vector<float> leftOut(actor.joints.size(), 0.0f);
    for (size_t j = 0; j < actor.joints.size(); ++j) {
        const ActorJoint& joint = actor.joints[j];
        const JointType type = halfType(joint.type);
        if (!joint.limits.any() || type == JointType::Stiff) continue;
        const Turns turns = turnsOf(clip, joint.child);
        const LastingTurns lasting = lastingTurns(joint.limits, type, joint.axis, turns, clip.rate);
        leftOut[j] = lasting.leftOut;
        if (leftOut[j] > 0.0f)
            putTurns(clip, joint.child, heldTurns(widened(joint, lasting), type, joint.axis, turns, clip.rate));
    }
    const std::string joints = farJoints(actor, leftOut);
    if (joints.empty()) return {};
    return fmt::format("Clip '{}' turns joints beyond what a body's do, for a moment or by far, and is held at their "
                       "limits: {}.",
                       clip.name, joints);
}

ClipNeeds needsOf(const Actor& actor, std::span<const BodyClip* const> clips)
{
    Actor widened = actor;  // a pair filtered for one clip is not needed again for later ones
    for (const BodyClip* clip : clips) {
        for (ActorJoint& joint : widened.joints)
            takeIn(joint.limits, halfType(joint.type), joint.axis, turnsOf(*clip, joint.child));
        for (const auto& pair : overlapsIn(widened, *clip)) widened.filtered.push_back(pair);
    }
    ClipNeeds needs;
    for (const ActorJoint& joint : widened.joints) needs.limits.push_back(joint.limits);
    needs.filtered.assign(widened.filtered.begin() + std::ssize(actor.filtered), widened.filtered.end());
    return needs;
}

void allow(Actor& actor, const ClipNeeds& needs)
{
    for (size_t j = 0; j < actor.joints.size(); ++j) actor.joints[j].limits = needs.limits[j];
    actor.filtered.insert(actor.filtered.end(), needs.filtered.begin(), needs.filtered.end());
    actor.notes.insert(actor.notes.end(), needs.notes.begin(), needs.notes.end());
}

}  // namespace knuckle
