#include "sim/rig/bodies/articulate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/rig/bodies/bone_bodies.h"
#include "sim/rig/bodies/merge_notes.h"
#include "sim/rig/joints/joint_particles.h"
#include "sim/rig/joints/plan_joint.h"
#include "sim/rig/limbs/limb_fill.h"

namespace knuckle {

namespace {

constexpr float IN_BODY = 1.5f;  // d: a joint is in a body with a particle as near as this

/// Hands over the drafts, including those that gave way to joints: they are in no body, so numberAsAdded() drops them.
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
    const auto [first, second] = hingeLimits(plan.limits);
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

/// Filters arms from the chest: an arm on a very short collar bone sits in the chest, and turns there like a body that
/// hangs on the chest itself.
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
            actor.filtered.push_back({std::min(joint.child, static_cast<uint32_t>(above)),
                                      std::max(joint.child, static_cast<uint32_t>(above))});
    }
}

/// The lattice of a figure shares its symmetry, with a layer on the plane, and stands on the ground: the lowest layer
/// is half a particle above the soles.
VoxelOptions latticeOf(const Figure& figure, const Solid& solid, VoxelOptions options)
{
    if (figure.model.bones.empty()) return options;
    const std::optional<Mirror>& mirror = figure.mirror;
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

Actor articulate(const Figure& figure, const Solid& solid, const ActorOptions& options)
{
    const Model& model = figure.model;
    Voxels voxels = voxelize(solid, latticeOf(figure, solid, options.voxels));
    Actor actor;
    actor.name = options.name.empty() ? model.name : options.name;
    actor.diameter = voxels.diameter;
    actor.notes = model.notes;
    std::vector<BodyDraft> drafts = cutIntoBodies(figure, solid, voxels, options.plan, actor.notes);
    noteMerged(figure, drafts, !options.plan.empty(), actor.notes);
    if (options.alongBones && drafts.size() > 1) fillAlongBones(figure, solid, drafts, voxels);
    std::vector<ParticleDraft> particles(voxels.positions.size());
    for (size_t p = 0; p < particles.size(); ++p) {
        particles[p].position = voxels.positions[p];
        particles[p].signedDistance = voxels.signedDistances[p];
        particles[p].outward = voxels.outward[p];
    }
    for (uint32_t b = 0; b < drafts.size(); ++b) {
        ActorBody& body = actor.bodies.emplace_back(ActorBody{drafts[b].name, {}, drafts[b].parent, {}});
        for (const uint32_t bone : drafts[b].mergedBones) body.mergedBones.push_back(model.bones[bone].name);
        for (const uint32_t p : drafts[b].particles) particles[p].bodies = {b};
    }
    const BodyCut cut{figure, drafts, voxels};
    for (uint32_t b = 1; b < drafts.size(); ++b) addJoints(actor, particles, planJoint(cut, b, options.articulation));
    collect(particles, actor);
    passShortBodies(actor);
    return actor;
}

}  // namespace knuckle
