#pragma once

#include <vector>

#include "sim/world/builder/collider_builder.h"
#include "sim/world/builder/fluid_builder.h"
#include "sim/world/builder/force_builder.h"
#include "sim/world/builder/joint_builder.h"
#include "sim/world/builder/loose_builder.h"
#include "sim/world/builder/motion_builder.h"

namespace knuckle {

/// Builds a World with all kinds of matter.
///
/// Returned indices stay valid. Bodies, joints and particles are added in the rest pose of their object, then placed as
/// a whole: beginObject(), addBody()..., addJoint()..., endObject(pose, velocity). A call out of this order, or with an
/// index that does not exist, is a std::logic_error.
class WorldBuilder : public JointBuilder,
                     public MotionBuilder,
                     public ColliderBuilder,
                     public LooseBuilder,
                     public FluidBuilder,
                     public ForceBuilder {
public:
    /// @param particleRadius [m], > 0.
    explicit WorldBuilder(float particleRadius, const Settings& settings = {}) : WorldDraft(particleRadius, settings) {}

    /// Groups links by body, fills centres, masses and assemblies, and validates. Afterwards the builder must not be
    /// used.
    World build();

private:
    /// Fills World::joints, once links exist: from shared particles and descriptions.
    void recordJoints();
    void recordGears();
    void assignAssemblies();
    /// Balls and capsules weigh density times volume. Not in a world with fluids, in which they displace their
    /// particles' cells.
    void weighRounds();
    void makeBodyLinks(uint32_t bodyIndex);
    /// Where objects are joined, particles have a common rest pose: their places at the start.
    void restWherePlaced();
    /// The part of a particle's mass that counts in one of its bodies, 0 ... 1.
    float massFraction(uint32_t particle, uint32_t body) const;
};

/// Lattice points of a box of `counts` particles an axis, spaced by `diameter`, centred on the origin [m].
std::vector<Vector3f> boxLattice(const Eigen::Vector3i& counts, float diameter);
/// Lattice points inside a sphere whose surface lies at `radius` from the origin [m].
std::vector<Vector3f> sphereLattice(float radius, float diameter);
/// Lattice points inside a capsule along y; `halfHeight` between the centre and a cap's centre [m].
std::vector<Vector3f> capsuleLattice(float radius, float halfHeight, float diameter);

}  // namespace knuckle
