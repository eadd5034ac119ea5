#include "sim/actor/bodies/articulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/actor/anatomy/name_pattern.h"
#include "sim/actor/bodies/bone_bodies.h"
#include "sim/actor/bodies/bone_options.h"
#include "sim/actor/bodies/fold.h"
#include "sim/actor/bodies/joint_particles.h"
#include "sim/actor/bodies/joint_ranges.h"
#include "sim/actor/bodies/merge_notes.h"
#include "sim/actor/limbs/limb_fill.h"
#include "sim/actor/limbs/limb_frame.h"
#include "sim/world/builder/joints.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr float IN_BODY = 1.5f;  // d: a joint is in a body that has a particle as near as this

// Which way a figure faces in its rest pose.
struct Bearings {
    Vector3f left{1, 0, 0};
    Vector3f forward{0, 0, 1};
    bool upright = true;
};

/// A model as its joints are planned from it.
struct Figure {
    const Model& model;
    const std::vector<BoneAnatomy>& anatomy;
    const std::vector<BodyDraft>& drafts;
    const Voxels& voxels;
    const std::optional<Mirror>& mirror;
    Bearings bearings = {};

    const BoneAnatomy& boneOf(uint32_t body) const { return anatomy[drafts[body].bone]; }
};

Bearings bearingsOf(const Model& model, const std::vector<BoneAnatomy>& anatomy)
{
    Bearings bearings;
    bearings.left = leftOf(model, anatomy);
    bearings.forward = bearings.left.cross(Vector3f::UnitY());
    bearings.upright = isUpright(model, anatomy);
    return bearings;
}

/// The direction in which the body leaves its joint: towards the next joint, of a finger's last body towards its next
/// bone, else towards its middle.
Vector3f directionOf(const Figure& figure, uint32_t body)
{
    const BodyDraft& draft = figure.drafts[body];
    std::vector<Vector3f> ends;
    for (const BodyDraft& other : figure.drafts)
        if (other.parent == static_cast<int32_t>(body)) ends.push_back(other.anchor);
    if (ends.empty() && figure.boneOf(body).part == BodyPart::Finger)
        if (const std::optional<Vector3f> end = limbEnd(figure.model, figure.anatomy, draft.bone))
            ends.push_back(draft.anchor + *end - boneHead(figure.model, draft.bone));
    for (size_t i = 0, all = ends.empty() ? draft.particles.size() : 0; i < all; ++i)
        ends.push_back(figure.voxels.positions[draft.particles[i]]);
    Vector3f sum = Vector3f::Zero();
    for (const Vector3f& end : ends) sum += end;
    const Vector3f along = sum / static_cast<float>(ends.size()) - draft.anchor;
    return along.norm() > 1e-3f * figure.voxels.diameter ? Vector3f(along.normalized()) : Vector3f(0, -1, 0);
}

/// Neck and head share a range, as the segments of a spine do.
uint32_t segmentsOf(const Figure& figure, BodyPart part)
{
    const auto kind = [](BodyPart p) { return p == BodyPart::Head ? BodyPart::Neck : p; };
    uint32_t count = 0;
    for (uint32_t b = 1; b < figure.drafts.size(); ++b) count += kind(figure.boneOf(b).part) == kind(part);
    return std::max(count, 1u);
}

LimbStance stanceOf(const Figure& figure, const JointPlan& plan)
{
    const BodyDraft &draft = figure.drafts[plan.child], &parent = figure.drafts[plan.parent];
    const BoneAnatomy& bone = figure.boneOf(plan.child);
    LimbStance stance;
    stance.part = bone.part;
    stance.along = plan.along;
    stance.forward = figure.bearings.forward;
    stance.outward = static_cast<float>(bone.side) * figure.bearings.left;
    stance.segments = segmentsOf(figure, stance.part);
    stance.upright = figure.bearings.upright;
    const Vector3f above = draft.anchor - parent.anchor;
    if (parent.parent >= 0 && above.norm() > figure.voxels.diameter) stance.above = above.normalized();
    return stance;
}

/// What clips do with a joint, and with the one on the other side.
std::vector<Turns> turnsOf(const Figure& figure, const JointPlan& plan)
{
    const uint32_t child = figure.drafts[plan.child].bone, parent = figure.drafts[plan.parent].bone;
    std::vector<Turns> turns = clipTurns(figure.model, child, parent);
    if (!figure.mirror) return turns;
    const uint32_t image = figure.mirror->images[child], above = figure.mirror->images[parent];
    if (image == NO_INDEX || above == NO_INDEX) return turns;
    for (Turns& others : clipTurns(figure.model, image, above))
        turns.push_back(mirrored(std::move(others), figure.mirror->plane.across));
    return turns;
}

/// The limits of a joint of a body, where its type is the one that it has there.
JointLimits rangeOf(const Figure& figure, const JointPlan& plan)
{
    const BoneAnatomy& bone = figure.boneOf(plan.child);
    if (bone.source == AnatomySource::Clip && plan.type == JointType::Hinge)
        return rangeInClips(plan.axis, turnsOf(figure, plan));
    if (!hasRange(bone.part) || rangedType(bone.part) != plan.type) return {};
    LimbStance stance = stanceOf(figure, plan);
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

/// Which way the joint lies, and about what it turns.
void placeJoint(const Figure& figure, JointPlan& plan)
{
    const BoneAnatomy& bone = figure.boneOf(plan.child);
    plan.anchor = figure.drafts[plan.child].anchor;
    plan.along = directionOf(figure, plan.child);
    plan.flexion = foldDirection(stanceOf(figure, plan), turnsOf(figure, plan));
    plan.axis = plan.along.cross(plan.flexion).normalized();
    plan.twistAxis = plan.along;
    if (bone.source == AnatomySource::Clip) plan.turnAbout(bone.axis);
}

JointPlan planJoint(const Figure& figure, uint32_t body, const ArticulationOptions& options)
{
    const BodyDraft& draft = figure.drafts[body];
    JointPlan plan;
    plan.parent = static_cast<uint32_t>(draft.parent);
    plan.child = body;
    plan.type = typeOf(figure.boneOf(body), options.limited);
    if (const JointType* type = findByPattern(options.types, draft.name)) plan.type = *type;
    placeJoint(figure, plan);
    if (options.limited) plan.limits = rangeOf(figure, plan);
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
    // Bodies that limits keep apart pass through each other, and need no room to turn in.
    plan.clear = options.clearJoints && !plan.limits.any();
    lockNarrowRanges(plan);
    return plan;
}

/// Hands over the drafts, also those that gave way to joints: they are in no body, and numberAsAdded() leaves them out.
void collect(const std::vector<ParticleDraft>& particles, Actor& actor)
{
    for (uint32_t p = 0; p < particles.size(); ++p) {
        actor.particles.push_back(particles[p].position);
        actor.signedDistances.push_back(particles[p].signedDistance);
        actor.outward.push_back(particles[p].outward);
        for (uint32_t body : particles[p].bodies) actor.bodies[body].particles.push_back(p);
    }
    numberAsAdded(actor);
}

void addJoints(Actor& actor, std::vector<ParticleDraft>& particles, const JointPlan& plan)
{
    const std::string name = actor.bodies[plan.child].name;
    const uint32_t crossBody = static_cast<uint32_t>(actor.bodies.size());
    const std::vector<uint32_t> shared = makeJointParticles(particles, plan, actor.diameter, crossBody);
    if (plan.type != JointType::Universal) {
        const Vector3f& axis = plan.type == JointType::Ball ? plan.twistAxis : plan.axis;
        actor.joints.push_back(
            {name, plan.type, plan.parent, plan.child, plan.anchor, axis, shared, plan.limits, plan.strength});
        return;
    }
    actor.bodies.push_back({name + "/cross", {}, static_cast<int32_t>(plan.parent), {}, true});
    actor.bodies[plan.child].parent = static_cast<int32_t>(crossBody);
    JointLimits first = plan.limits, second = plan.limits;
    second.bend = plan.limits.secondBend;
    first.secondBend = second.secondBend = {};
    const Vector3f secondAxis = plan.along.cross(plan.axis).normalized();
    actor.joints.push_back({name + "/cross",
                            plan.type,
                            plan.parent,
                            crossBody,
                            plan.anchor,
                            plan.axis,
                            {shared[0], shared[1]},
                            first,
                            plan.strength});
    actor.joints.push_back({name,
                            plan.type,
                            crossBody,
                            plan.child,
                            plan.anchor,
                            secondAxis,
                            {shared[2], shared[3]},
                            second,
                            plan.strength});
}

/// An arm hangs on a collar bone so short that it sits in the chest, and turns there like what hangs on the chest
/// itself: the two never touch.
void passShortBodies(Actor& actor)
{
    for (const ActorJoint& joint : actor.joints) {
        const int32_t middle = parentBody(actor, joint.child);
        const int32_t above = middle < 0 ? -1 : parentBody(actor, static_cast<uint32_t>(middle));
        if (above < 0 || !joint.limits.any()) continue;
        const auto isNear = [&](uint32_t p) {
            return (actor.particles[p] - joint.anchor).norm() < IN_BODY * actor.diameter;
        };
        if (std::ranges::any_of(actor.bodies[above].particles, isNear))
            actor.passes.push_back({std::min(joint.child, static_cast<uint32_t>(above)),
                                    std::max(joint.child, static_cast<uint32_t>(above))});
    }
}

/// The lattice of a figure mirrors as it does, having a layer on its plane of symmetry, and stands on the ground where
/// its soles do, half a particle above them.
VoxelOptions latticeOf(const Model& model, const std::optional<Mirror>& mirror, const Solid& solid,
                       VoxelOptions options)
{
    if (model.bones.empty()) return options;
    Vector3f centre = solid.bounds().center();
    if (mirror && mirror->axis() >= 0) centre -= mirror->plane.distance(centre) * mirror->plane.across;
    if (const float d = options.diameter; d > 0.0f) {
        const float lowest = solid.bounds().min().y() + 0.5f * d;
        centre.y() = lowest + d * std::round((centre.y() - lowest) / d);
    }
    options.centre = centre;
    return options;
}

}  // namespace

Actor articulate(const Model& model, const Solid& solid, const ActorOptions& options)
{
    checkBoneNames(model, options.articulation);
    const std::map<uint32_t, BoneRole> wanted = rolesWanted(model, options.articulation);
    const std::vector<BoneAnatomy> anatomy = readAnatomy(model, wanted);
    std::optional<Mirror> mirror = findMirror(BoneTree(model));
    if (mirror) mirror->keepAlike(anatomy);
    Voxels voxels = voxelize(solid, latticeOf(model, mirror, solid, options.voxels));
    Actor actor;
    actor.name = options.name.empty() ? model.name : options.name;
    actor.diameter = voxels.diameter;
    actor.notes = model.notes;
    const Bearings bearings = bearingsOf(model, anatomy);
    std::vector<BodyDraft> drafts = cutIntoBodies(model, solid, anatomy, mirror ? &*mirror : nullptr, bearings.forward,
                                                  voxels, actor.notes);
    noteMerged(model, anatomy, wanted, drafts, actor.notes);
    if (options.alongBones && drafts.size() > 1)
        fillAlongBones(model, solid, anatomy, bearings.forward, mirror ? &*mirror : nullptr, drafts, voxels);
    std::vector<ParticleDraft> particles(voxels.positions.size());
    for (size_t p = 0; p < particles.size(); ++p) {
        particles[p].position = voxels.positions[p];
        particles[p].signedDistance = voxels.signedDistances[p];
        particles[p].outward = voxels.outward[p];
    }
    for (uint32_t b = 0; b < drafts.size(); ++b) {
        ActorBody& body = actor.bodies.emplace_back(ActorBody{drafts[b].name, {}, drafts[b].parent, {}});
        for (const uint32_t bone : drafts[b].mergedBones) body.mergedBones.push_back(model.bones[bone].name);
        for (uint32_t p : drafts[b].particles) {
            particles[p].bodies = {b};
        }
    }
    const Figure figure{model, anatomy, drafts, voxels, mirror, bearings};
    for (uint32_t b = 1; b < drafts.size(); ++b)
        addJoints(actor, particles, planJoint(figure, b, options.articulation));
    collect(particles, actor);
    passShortBodies(actor);
    return actor;
}

}  // namespace knuckle
