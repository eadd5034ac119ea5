#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/rig/model_source.h"
#include "sim/world/builder/builder.h"
#include "sim/world/world.h"

namespace knuckle {

/// A particle ragdoll in its rest pose: what `knuckle voxelize` writes and a scene loads. SI units, +Y up.
struct ActorBody {
    std::string name;                      ///< The bone's.
    std::vector<uint32_t> particles;       ///< Into Actor::particles. A shared one is in several bodies.
    int32_t parent = -1;                   ///< Into Actor::bodies.
    std::vector<std::string> mergedBones;  ///< Bones too small for a body of their own.
    bool isCross = false;                  ///< The flat middle body of a universal joint.
};

struct ActorJoint {
    std::string name;                  ///< The child bone's.
    JointType type = JointType::Ball;  ///< For a universal joint, that of both its hinges.
    uint32_t parent = 0, child = 0;    ///< Into Actor::bodies.
    Vector3f anchor{0, 0, 0};          ///< The bone's head [m].
    Vector3f axis{0, 0, 1};            ///< Unit; for a ball the child's axis, which its limits are about.
    std::vector<uint32_t> sharedParticles;
    JointLimits limits = {};  ///< Each half of a universal joint has its `bend`.
    JointStrength strength = {};
};

/// The bodies that move a point, heaviest first.
struct BodyWeights {
    std::array<uint32_t, 4> bodies{};          ///< Into Actor::bodies.
    std::array<float, 4> weights{1, 0, 0, 0};  ///< Sum 1.
};

/// The mesh that an actor was made of, for those who move it themselves.
struct ActorSkin {
    std::vector<Vector3f> vertices;  ///< At rest [m].
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<BodyWeights> ofVertices, ofParticles;  ///< Of particles: as many as the actor has, or none.

    bool empty() const { return vertices.empty() && ofParticles.empty(); }
};

struct Actor {
    std::string name;
    float diameter = 0.05f;              ///< Particle diameter [m].
    std::vector<Vector3f> particles;     ///< Rest positions [m].
    std::vector<float> signedDistances;  ///< Per particle: distance to the surface [m], negative inside; or none.
    std::vector<Vector3f> outward;       ///< Per particle: SurfaceDistance::outward; or none.
    std::vector<ActorBody> bodies;
    std::vector<ActorJoint> joints;
    /// Pairs of bodies that never touch, besides those that a joint with limits connects.
    std::vector<std::array<uint32_t, 2>> filtered = {};
    ModelSource model = {};          ///< What it was made from.
    std::vector<std::string> notes;  ///< What was merged, dropped or assumed, one sentence each.
    ActorSkin skin = {};             ///< Of makeActorSkin(), or none.
};

/// The body that a body hangs on, past the cross of a universal joint; -1 for the first.
int32_t parentBody(const Actor& actor, uint32_t body);

/// Numbers the particles in the order of addActor(), so that an actor file has the same numbers as a run's export.
/// Particles without a body are left out.
void numberAsAdded(Actor& actor);

/// Data for contacts on a particle's place in the skin; empty if the actor has none.
SurfaceDistance surfaceOf(const Actor& actor, uint32_t particle);

/// Whether two particles are so near each other at rest that they never touch.
bool touchAtRest(const Actor& actor, uint32_t particle, uint32_t other);
/// Whether two bodies never touch: Actor::filtered, or limits at a joint between them.
bool neverTouch(const Actor& actor, uint32_t body, uint32_t other);

/// Adds the actor as one object, placed at `pose`. @returns the object's index.
uint32_t addActor(WorldBuilder& builder, const Actor& actor, uint32_t material, const Pose& pose,
                  const Vector3f& velocity = {0, 0, 0});

}  // namespace knuckle
