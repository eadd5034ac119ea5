#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/no_index.h"
#include "sim/world/animation/animation.h"
#include "sim/world/animation/collider_motion.h"
#include "sim/world/drive/puppet.h"
#include "sim/world/forces/forces.h"
#include "sim/world/joint/joint.h"
#include "sim/world/matter/emitter.h"
#include "sim/world/matter/skin.h"
#include "sim/world/matter/soft_matter.h"
#include "sim/world/matter/strand.h"
#include "sim/world/matter/surface.h"
#include "sim/world/settings.h"
#include "sim/world/space/collider_grid.h"
#include "sim/world/space/region.h"

/// Plain data that describes a world before the GPU sees it.
///
/// Conventions, valid everywhere: SI units, right-handed, +Y up, quaternions stored xyzw (Eigen's order), angles in
/// radians, colours linear RGB in 0-1.
namespace knuckle {

using Eigen::Quaternionf;
using Eigen::Vector3f;

/// What particles are made of.
struct Material {
    std::string name;
    float density = 1000.0f;       ///< [kg/m3], > 0. A particle of a body weighs density * diameter^3,
                                   ///< those of a ball or capsule together density * its volume.
    float staticFriction = 0.5f;   ///< Coulomb's mu while sticking, >= 0. A contact takes both sides' mean.
    float kineticFriction = 0.5f;  ///< Coulomb's mu while sliding, 0 ... staticFriction.
    /// Share of the speed that a collision leaves, 0 ... 1. A contact takes the larger of both sides'.
    float restitution = 0.0f;
    /// Rolling resistance of balls and capsules, >= 0: on a slope below its arc tangent they do not start to roll.
    float rollingFriction = 0.0f;
    Vector3f color{0.8f, 0.8f, 0.8f};  ///< Linear RGB, 0-1, used when colouring by material.
    bool fluid = false;                ///< Its particles are loose and flow.
    float viscosity = 0.001f;          ///< Fluids: dynamic [Pa s], >= 0. Water 0.001, honey 10.
    float surfaceTension = 0.0f;       ///< Fluids: of their free surface [N/m], >= 0. Water 0.073.
    Elasticity elasticity = {};        ///< Of soft bodies.
};

struct Particle {
    Vector3f position{0, 0, 0};    ///< [m]
    Vector3f velocity{0, 0, 0};    ///< [m/s]
    float mass = 1.0f;             ///< [kg], > 0. Ignored in a fixed body.
    uint32_t material = 0;         ///< Index into World::materials.
    uint32_t body = NO_INDEX;      ///< The first body it belongs to, NO_INDEX for loose particles.
    uint32_t bodyCount = 0;        ///< How many bodies share it: 0 loose, 1 ordinary, 2 or more a joint.
    uint32_t assembly = NO_INDEX;  ///< Index of the set of bodies connected by joints, or of a soft body.
    /// Where it stands in the rest pose of its assembly [m]. Two particles of one assembly nearer to each other there
    /// than a diameter never touch (physics: self-collision filtered by rest distance).
    Vector3f restPosition{0, 0, 0};
    /// False for the cross of a universal joint, which would else be stopped by the bodies around it at once.
    bool touchesAssembly = true;
    /// Adds to the distance at rest below which it never touches another particle of its assembly [diameters], >= 0:
    /// the flesh around an actor's joints folds instead of holding the joint open.
    float selfMargin = 0.0f;
    bool pinned = false;      ///< A loose particle that stays where it is put: of a soft body that is held there.
    SurfaceDistance surface;  ///< In its body; counts only where bodyCount is 1.
};

/// The paper's listing 1, on the host. Links are grouped by body: a body's block is linkStart ... linkStart+linkCount.
struct Link {
    uint32_t particle = 0;
    uint32_t body = 0;
    Vector3f restOffset{0, 0, 0};  ///< posInRigidBody, r of eq. 8: from the body's centre at rest [m].
    float mass = 0.0f;             ///< The share of the particle's mass that counts in this body [kg].
};

enum class Motion : uint32_t {
    Dynamic,   ///< Simulated.
    Fixed,     ///< Stays where it is, for ever or until Body::releaseTime; its particles have infinite mass.
    Animated,  ///< Moves as a clip says until Body::releaseTime, and answers to nothing.
};

/// A ball or a capsule along y about the origin of the rest pose: what touches it meets this, not its particles.
struct RoundShape {
    float radius = 0.0f;      ///< [m], 0 for none.
    float halfHeight = 0.0f;  ///< From the centre to a cap's centre [m]; 0 for a ball.
    bool exists() const { return radius > 0.0f; }
    float volume() const { return 3.14159265f * radius * radius * (4.0f / 3.0f * radius + 2.0f * halfHeight); }
};

/// A rigid body: a block of links.
struct Body {
    std::string name;
    Motion motion = Motion::Dynamic;
    float releaseTime =
        std::numeric_limits<float>::infinity();  ///< Of one that is not dynamic: it is let go then [s], >= 0.
    bool watched = false;                        ///< One of World::releases may let go of it before, or
                                                 ///< a release after it was caught.
    uint32_t material = 0;
    uint32_t assembly = NO_INDEX;
    uint32_t linkStart = 0, linkCount = 0;
    uint32_t object = NO_INDEX;  ///< Index into World::objects: what the scene calls one thing.
    RoundShape round;            ///< Radius 0 for what is neither a ball nor a capsule.
    bool isCross = false;        ///< The flat middle body of a universal joint.
    /// Bodies of its object that it never touches, and that say the same of it: what it hangs on where limits hold it,
    /// and what it overlaps in most of a clip.
    std::vector<uint32_t> filtered;
    float mass = 0.0f;                 ///< Sum of its particles' shares of mass [kg].
    Vector3f restCentre{0, 0, 0};      ///< Mass centre in the object's rest pose [m].
    Vector3f position{0, 0, 0};        ///< Where restCentre starts [m].
    Quaternionf rotation{1, 0, 0, 0};  ///< How the rest pose is turned at the start.
};

/// One thing of the scene: a ragdoll, a jointed pair, a single rigid body. For names in exports and for cameras.
struct Object {
    std::string name;
    uint32_t bodyStart = 0, bodyCount = 0;

    uint32_t bodyEnd() const { return bodyStart + bodyCount; }
    bool has(uint32_t body) const { return body >= bodyStart && body < bodyEnd(); }
};

/// An obstacle: it stays where it is, or moves as World::colliderMotions say, and answers to nothing.
struct Collider : Region {
    uint32_t grid = NO_INDEX;  ///< Mesh and heightfield: index into World::colliderGrids.
    float staticFriction = 0.5f;
    float kineticFriction = 0.5f;
    Vector3f color{0.45f, 0.47f, 0.5f};
    bool visible = true;  ///< Walls of a container are often felt but not drawn.
};

enum class ReleaseCause : uint32_t { Impulse, Touch, Region };

/// What lets go of bodies of an object when something happens to any of them. Whichever of several is first counts.
struct Release {
    ReleaseCause cause = ReleaseCause::Impulse;
    std::vector<uint32_t> bodies;  ///< Of one object; with each all that hangs on it, and not all of them dynamic.
    float impulse = 0.0f;          ///< Impulse: that contacts give to one of them in a step [N s], > 0.
    uint32_t firstParticle = 0, endParticle = 0;  ///< Touch: of these particles.
    bool driven = false;                          ///< A puppet's bodies are driven from then on, not limp.
    Region region;  ///< Region: one of their particles has its centre in it; box, sphere or capsule.
};

struct World {
    float particleRadius = 0.05f;  ///< [m], > 0; one for all.
    Settings settings;
    std::vector<Material> materials;
    std::vector<Particle> particles;
    std::vector<Body> bodies;
    std::vector<Link> links;
    std::vector<Joint> joints;  ///< Those of one pair of bodies are one.
    std::vector<Object> objects;
    std::vector<BodyClip> clips;
    std::vector<Animation> animations;
    std::vector<Puppet> puppets;
    std::vector<Release> releases;
    std::vector<Collider> colliders;              ///< Where they begin.
    std::vector<ColliderMotion> colliderMotions;  ///< In the order of colliders.
    std::vector<SoftBody> softBodies;
    std::vector<Cluster> clusters;                        ///< Grouped by soft body.
    std::vector<Link> clusterLinks;                       ///< Grouped by cluster, which is what Link::body says here.
    std::vector<Strand> strands;                          ///< Ropes and cloth.
    std::vector<std::array<uint32_t, 3>> clothTriangles;  ///< Particles of cloth between which the air finds it.
    std::vector<ColliderGrid> colliderGrids;
    std::vector<Skin> skins;  ///< Only drawn.
    uint32_t assemblyCount = 0;
    /// Rest distance of fluid particles [m], 0.3 ... 0.6 diameters. A fluid particle weighs density * spacing^3.
    float fluidSpacing = 0.05f;
    uint32_t fluidCount = 0;  ///< Fluid particles; they stand behind all others in `particles`.
    /// Their pools are the last of the fluid particles, in this order; what is in a pool is nowhere yet.
    std::vector<Emitter> emitters;
    std::vector<Region> drains;  ///< Fluids vanish in them; planes, boxes, spheres, capsules.
    std::optional<Wind> wind;    ///< None: no air.
    std::vector<ForceField> forceFields;

    /// Particles in the pools at the start.
    uint32_t pooledCount() const;
    /// Particles that are not fluid.
    uint32_t solidCount() const { return static_cast<uint32_t>(particles.size()) - fluidCount; }
    float diameter() const { return 2.0f * particleRadius; }
};

/// Whether a particle stays where it is at first: it is pinned, or a fixed body has it.
inline bool isFixed(const World& world, const Particle& particle)
{
    return particle.pinned || (particle.body != NO_INDEX && world.bodies[particle.body].motion == Motion::Fixed);
}

inline const Object& objectOf(const World& world, const Animation& animation)
{
    return world.objects[animation.object];
}

inline const Object& objectOf(const World& world, const Puppet& puppet)
{
    return objectOf(world, world.animations[puppet.animation]);
}

/// Whether two bodies never touch (Body::filtered).
inline bool areFiltered(const World& world, uint32_t body, uint32_t other)
{
    return std::ranges::find(world.bodies[body].filtered, other) != world.bodies[body].filtered.end();
}

/// Whether something lets go of a body that is held or animated, or may.
inline bool mayBeLetGo(const Body& body)
{
    return body.motion != Motion::Dynamic &&
           (body.watched || body.releaseTime < std::numeric_limits<float>::infinity());
}

/// Whether a body never answers to anything: what joints and ropes connect is planned as if all others always did.
inline bool neverResponds(const Body& body)
{
    return body.motion == Motion::Fixed && !mayBeLetGo(body);
}

/// Whether a particle never moves: it is pinned, or a body has it that never responds.
inline bool isFixedForEver(const World& world, const Particle& particle)
{
    return particle.pinned || (particle.body != NO_INDEX && neverResponds(world.bodies[particle.body]));
}

/// Nearer to a solid particle no fluid begins [m].
float fluidClearance(const World& world);

/// Checks every invariant that the solver relies on: indices in range, links grouped by body, finite positions,
/// positive masses, shared particles consistent with the links. It is the one place that does, for Worlds of any
/// origin.
/// @throws InputError naming the first that fails where a scene file can be the cause, else std::logic_error.
void validate(const World& world);

}  // namespace knuckle
