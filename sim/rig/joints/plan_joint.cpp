#include "sim/rig/joints/plan_joint.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/base/errors.h"
#include "sim/rig/anatomy/clip_turns.h"
#include "sim/rig/anatomy/names/name_pattern.h"
#include "sim/rig/joints/fold.h"
#include "sim/rig/joints/joint_ranges.h"
#include "sim/world/builder/parts/joints.h"

namespace knuckle {

namespace {

/// The direction in which the body leaves its joint: towards the next joint, for a finger's last body towards its next
/// bone, else towards its middle.
Vector3f directionOf(const BodyCut& cut, uint32_t body)
{
    const BodyDraft& draft = cut.drafts[body];
    std::vector<Vector3f> ends;
    for (const BodyDraft& other : cut.drafts)
        if (other.parent == static_cast<int32_t>(body)) ends.push_back(other.anchor);
    if (ends.empty() && cut.boneOf(body).part == BodyPart::Finger)
        if (const std::optional<Vector3f> end = limbEnd(cut.figure, draft.bone))
            ends.push_back(draft.anchor + *end - cut.figure.tree.heads[draft.bone]);
    for (size_t i = 0, all = ends.empty() ? draft.particles.size() : 0; i < all; ++i)
        ends.push_back(cut.voxels.positions[draft.particles[i]]);
    Vector3f sum = Vector3f::Zero();
    for (const Vector3f& end : ends) sum += end;
    const Vector3f along = sum / static_cast<float>(ends.size()) - draft.anchor;
    return along.norm() > 1e-3f * cut.voxels.diameter ? Vector3f(along.normalized()) : Vector3f(0, -1, 0);
}

/// Neck and head share a range, as the segments of a spine do.
uint32_t segmentsOf(const BodyCut& cut, BodyPart part)
{
    const auto kind = [](BodyPart p) { return p == BodyPart::Head ? BodyPart::Neck : p; };
    uint32_t count = 0;
    for (uint32_t b = 1; b < cut.drafts.size(); ++b) count += kind(cut.boneOf(b).part) == kind(part);
    return std::max(count, 1u);
}

LimbStance stanceOf(const BodyCut& cut, const JointPlan& plan)
{
    const BodyDraft &draft = cut.drafts[plan.child], &parent = cut.drafts[plan.parent];
    const BoneAnatomy& bone = cut.boneOf(plan.child);
    LimbStance stance;
    stance.part = bone.part;
    stance.along = plan.along;
    stance.forward = cut.figure.forward;
    stance.outward = static_cast<float>(bone.side) * cut.figure.left;
    stance.segments = segmentsOf(cut, stance.part);
    stance.upright = cut.figure.upright;
    const Vector3f above = draft.anchor - parent.anchor;
    if (parent.parent >= 0 && above.norm() > cut.voxels.diameter) stance.above = above.normalized();
    return stance;
}

/// Turns of a joint in clips, with those of the joint on the other side.
std::vector<Turns> turnsOf(const BodyCut& cut, const JointPlan& plan)
{
    const uint32_t child = cut.drafts[plan.child].bone, parent = cut.drafts[plan.parent].bone;
    const std::optional<Mirror>& mirror = cut.figure.mirror;
    std::vector<Turns> turns = clipTurns(cut.figure.model, child, parent);
    if (!mirror) return turns;
    const uint32_t image = mirror->images[child], above = mirror->images[parent];
    if (image == NO_INDEX || above == NO_INDEX) return turns;
    for (Turns& others : clipTurns(cut.figure.model, image, above))
        turns.push_back(mirrored(std::move(others), mirror->plane.across));
    return turns;
}

/// The limits of a joint of a body, if its type is the usual one there.
JointLimits rangeOf(const BodyCut& cut, const JointPlan& plan)
{
    const BoneAnatomy& bone = cut.boneOf(plan.child);
    if (bone.source == AnatomySource::Clip && plan.type == JointType::Hinge)
        return rangeInClips(plan.axis, turnsOf(cut, plan));
    if (!hasRange(bone.part) || rangedType(bone.part) != plan.type) return {};
    LimbStance stance = stanceOf(cut, plan);
    if (plan.type == JointType::Ball) stance.along = plan.twistAxis;
    if (plan.type == JointType::Hinge) stance.bend = restBend(stance, plan.axis);
    return ordinaryRange(stance);
}

JointType typeOf(const BoneAnatomy& bone, bool limited)
{
    if (bone.role == BoneRole::Twist) return JointType::Stiff;
    if (bone.source == AnatomySource::Clip) return JointType::Hinge;
    return limited && hasRange(bone.part) ? rangedType(bone.part) : jointTypeOf(bone.part);
}

/// Sets the joint's direction and axis.
void placeJoint(const BodyCut& cut, JointPlan& plan)
{
    const BoneAnatomy& bone = cut.boneOf(plan.child);
    plan.anchor = cut.drafts[plan.child].anchor;
    plan.along = directionOf(cut, plan.child);
    plan.flexion = foldDirection(stanceOf(cut, plan), turnsOf(cut, plan));
    plan.axis = plan.along.cross(plan.flexion).normalized();
    plan.twistAxis = plan.along;
    if (bone.source == AnatomySource::Clip) plan.turnAbout(bone.axis);
}

}  // namespace

JointPlan planJoint(const BodyCut& cut, uint32_t body, const ArticulationOptions& options)
{
    const BodyDraft& draft = cut.drafts[body];
    JointPlan plan;
    plan.parent = static_cast<uint32_t>(draft.parent);
    plan.child = body;
    plan.type = typeOf(cut.boneOf(body), options.limited);
    if (const JointType* type = findByPattern(options.types, draft.name)) plan.type = *type;
    placeJoint(cut, plan);
    if (options.limited) plan.limits = rangeOf(cut, plan);
    const JointLimits* limits = findByPattern(options.limits, draft.name);
    if (limits) {
        plan.limits = *limits;
        for (const std::string& name : plan.limits.misplacedIn(plan.type))
            throw InputError(
                fmt::format("joint for bone '{}': a {} joint has no limit `{}`; give another type or limit", draft.name,
                            jointTypeName(plan.type), name));
    }
    if (const JointStrength* strength = findByPattern(options.strengths, draft.name)) plan.strength = *strength;
    if (const Vector3f* axis = findByPattern(options.axes, draft.name)) {
        if (!limits) plan.limits = {};
        plan.twistAxis = axis->normalized();
        plan.turnAbout(plan.twistAxis);
    }
    // Bodies that limits keep apart do not collide, and need no room to turn.
    plan.clear = options.clearJoints && !plan.limits.any();
    lockNarrowRanges(plan);
    return plan;
}

}  // namespace knuckle
