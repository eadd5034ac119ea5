#include "sim/actor/bodies/articulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/actor/bodies/bone_bodies.h"
#include "sim/actor/bodies/joint_particles.h"
#include "sim/actor/bodies/joint_ranges.h"
#include "sim/world/builder/joints.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr float BENT = 0.15f;  // sine of the rest bend from which a hinge's axis is taken from it

// Which way a figure faces in its rest pose.
struct Bearings {
    Vector3f left{1, 0, 0};
    Vector3f forward{0, 0, 1};
};

Bearings bearingsOf(const Model& model)
{
    std::vector<std::string> names;
    std::vector<Vector3f> places;
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        names.push_back(model.bones[b].name);
        places.push_back(boneHead(model, b));
    }
    Bearings bearings;
    bearings.left = leftOf(names, places);
    bearings.forward = bearings.left.cross(Vector3f::UnitY());
    return bearings;
}

int32_t firstChild(const Model& model, uint32_t bone)
{
    for (uint32_t b = bone + 1; b < model.bones.size(); ++b) {
        if (model.bones[b].parent == static_cast<int32_t>(bone)) {
            return static_cast<int32_t>(b);
        }
    }
    return -1;
}

std::string nameOf(const Model& model, int32_t bone)
{
    return bone < 0 ? std::string() : model.bones[bone].name;
}

// The direction in which the body leaves its joint: towards the next joint, else towards its middle.
Vector3f directionOf(const std::vector<BodyDraft>& drafts, uint32_t body, const Voxels& voxels)
{
    Vector3f end = Vector3f::Zero();
    float count = 0.0f;
    for (const BodyDraft& draft : drafts) {
        if (draft.parent == static_cast<int32_t>(body)) {
            end += draft.anchor;
            count += 1.0f;
        }
    }
    if (count == 0.0f) {
        for (uint32_t p : drafts[body].particles) {
            end += voxels.positions[p];
        }
        count = static_cast<float>(drafts[body].particles.size());
    }
    const Vector3f along = end / count - drafts[body].anchor;
    return along.norm() > 1e-3f * voxels.diameter ? Vector3f(along.normalized()) : Vector3f(0, -1, 0);
}

// Which way a hinge bends, from the words of its bone: knees back, toes and everything else forward, or up where the
// limb itself points forward.
Vector3f bendDirection(const std::string& name, const Vector3f& along, const Bearings& bearings)
{
    std::string words = name;
    std::transform(words.begin(), words.end(), words.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto says = [&](const char* part) { return words.find(part) != std::string::npos; };
    const bool arm = says("arm") || says("elbow");
    const bool leg = !arm && (says("leg") || says("knee") || says("shin") || says("calf"));
    const Vector3f wanted = leg ? Vector3f(-bearings.forward) : bearings.forward;
    return std::abs(wanted.dot(along)) < 0.8f ? perpendicular(wanted, along) : perpendicular(Vector3f::UnitY(), along);
}

BodyPart partOf(const Model& model, const BodyDraft& draft)
{
    return partFromName(draft.name, nameOf(model, model.bones[draft.bone].parent),
                        nameOf(model, firstChild(model, draft.bone)));
}

/// Neck and head share a range, as the segments of a spine do.
uint32_t segmentsOf(const Model& model, const std::vector<BodyDraft>& drafts, BodyPart part)
{
    const auto kind = [](BodyPart p) { return p == BodyPart::Head ? BodyPart::Neck : p; };
    uint32_t count = 0;
    for (size_t b = 1; b < drafts.size(); ++b) count += kind(partOf(model, drafts[b])) == kind(part);
    return std::max(count, 1u);
}

/// The limits of a joint of a human body, where its type is the one that it has there.
JointLimits rangeOf(const Model& model, const std::vector<BodyDraft>& drafts, const JointPlan& plan,
                    const Bearings& bearings)
{
    const BodyDraft &draft = drafts[plan.child], &parent = drafts[plan.parent];
    LimbStance stance;
    stance.part = partOf(model, draft);
    if (!hasRange(stance.part) || rangedType(stance.part) != plan.type) return {};
    stance.along = plan.type == JointType::Ball ? plan.twistAxis : plan.along;
    stance.forward = bearings.forward;
    stance.outward = static_cast<float>(sideFromName(draft.name)) * bearings.left;
    stance.segments = segmentsOf(model, drafts, stance.part);
    const Vector3f above = draft.anchor - parent.anchor;
    if (plan.type == JointType::Hinge && parent.parent >= 0 && above.norm() > 0.0f)
        stance.bend = std::atan2(plan.along.dot(plan.axis.cross(above.normalized())),
                                 plan.along.dot(above.normalized()));
    return ordinaryRange(stance);
}

JointPlan planJoint(const Model& model, const std::vector<BodyDraft>& drafts, uint32_t body, const Voxels& voxels,
                    const ArticulationOptions& options, const Bearings& bearings)
{
    const BodyDraft& draft = drafts[body];
    const uint32_t parent = static_cast<uint32_t>(draft.parent);
    JointPlan plan;
    plan.type = jointTypeFromName(draft.name, nameOf(model, model.bones[draft.bone].parent),
                                  nameOf(model, firstChild(model, draft.bone)));
    const BodyPart part = partOf(model, draft);
    if (options.limited && hasRange(part)) plan.type = rangedType(part);
    if (const auto found = options.types.find(draft.name); found != options.types.end()) {
        plan.type = found->second;
    }
    plan.parent = parent;
    plan.child = body;
    plan.anchor = draft.anchor;
    // What bends by little does not need the room.
    const bool bendsLittle = part == BodyPart::Spine || part == BodyPart::Neck || part == BodyPart::Clavicle;
    plan.clear = options.clearJoints && !(options.limited && bendsLittle);
    plan.along = directionOf(drafts, body, voxels);
    plan.flexion = bendDirection(draft.name, plan.along, bearings);
    const Vector3f above = draft.anchor - drafts[parent].anchor;
    if (drafts[parent].parent >= 0 && above.norm() > voxels.diameter) {
        const Vector3f bend = above.normalized().cross(plan.along);
        const Vector3f deviation = plan.along - plan.along.dot(above.normalized()) * above.normalized();
        // A limb that is bent at rest shows its hinge's axis, unless it is bent the wrong way (a knee forward).
        if (bend.norm() > BENT && deviation.dot(plan.flexion) > 0.5f * deviation.norm()) {
            plan.flexion = perpendicular(deviation, plan.along);
        }
    }
    plan.axis = plan.along.cross(plan.flexion).normalized();
    plan.twistAxis = plan.along;
    if (options.limited) plan.limits = rangeOf(model, drafts, plan, bearings);
    if (const auto found = options.limits.find(draft.name); found != options.limits.end()) {
        plan.limits = found->second;
        for (const std::string& name : plan.limits.misplacedIn(plan.type))
            throw InputError(
                fmt::format("joint for bone '{}': a {} joint has no limit `{}`; give another type or limit", draft.name,
                            jointTypeName(plan.type), name));
    }
    if (const auto found = options.strengths.find(draft.name); found != options.strengths.end())
        plan.strength = found->second;
    if (const auto found = options.axes.find(draft.name); found != options.axes.end()) {
        if (!options.limits.contains(draft.name)) plan.limits = {};
        plan.twistAxis = found->second.normalized();
        plan.turnAbout(plan.twistAxis);
    }
    lockNarrowRanges(plan);
    return plan;
}

template <typename Value>
void checkOverrides(const Model& model, const std::map<std::string, Value>& overrides)
{
    for (const auto& [name, value] : overrides)
        if (std::ranges::find(model.bones, name, &Bone::name) == model.bones.end())
            throw InputError(
                fmt::format("joint for bone '{}': the model '{}' has no bone of that name", name, model.name));
}

// The actor without the particles that gave way to joints; indices are renumbered without gaps.
void collect(const std::vector<ParticleDraft>& particles, Actor& actor)
{
    std::vector<uint32_t> index(particles.size(), NO_INDEX);
    for (size_t p = 0; p < particles.size(); ++p) {
        if (particles[p].bodies.empty()) {
            continue;
        }
        index[p] = static_cast<uint32_t>(actor.particles.size());
        actor.particles.push_back(particles[p].position);
        actor.signedDistances.push_back(particles[p].signedDistance);
        actor.outward.push_back(particles[p].outward);
        for (uint32_t body : particles[p].bodies) {
            actor.bodies[body].particles.push_back(index[p]);
        }
    }
    for (ActorJoint& joint : actor.joints) {
        for (uint32_t& particle : joint.sharedParticles) {
            particle = index[particle];
        }
    }
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

}  // namespace

Actor articulate(const Model& model, const ActorOptions& options)
{
    checkOverrides(model, options.articulation.types);
    checkOverrides(model, options.articulation.axes);
    checkOverrides(model, options.articulation.limits);
    checkOverrides(model, options.articulation.strengths);
    const Voxels voxels = voxelize(model.vertices, model.triangles, options.voxels);
    Actor actor;
    actor.name = options.name.empty() ? model.name : options.name;
    actor.diameter = voxels.diameter;
    actor.notes = model.notes;
    const std::vector<BodyDraft> drafts = cutIntoBodies(model, voxels, actor.notes);
    std::vector<ParticleDraft> particles(voxels.positions.size());
    for (size_t p = 0; p < particles.size(); ++p) {
        particles[p].position = voxels.positions[p];
        particles[p].signedDistance = voxels.signedDistances[p];
        particles[p].outward = voxels.outward[p];
    }
    for (uint32_t b = 0; b < drafts.size(); ++b) {
        actor.bodies.push_back({drafts[b].name, {}, drafts[b].parent, drafts[b].mergedBones});
        for (uint32_t p : drafts[b].particles) {
            particles[p].bodies = {b};
        }
    }
    const Bearings bearings = bearingsOf(model);
    for (uint32_t b = 1; b < drafts.size(); ++b) {
        addJoints(actor, particles, planJoint(model, drafts, b, voxels, options.articulation, bearings));
    }
    collect(particles, actor);
    return actor;
}

}  // namespace knuckle
