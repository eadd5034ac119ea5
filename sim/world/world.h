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
#include "sim/world/joint/gear.h"
#include "sim/world/joint/joint.h"
#include "sim/world/matter/body_shape.h"
#include "sim/world/matter/drawn_matter.h"
#include "sim/world/matter/emitter.h"
#include "sim/world/matter/finish.h"
#include "sim/world/matter/fluid_look.h"
#include "sim/world/matter/skin.h"
#include "sim/world/matter/soft_matter.h"
#include "sim/world/matter/strand.h"
#include "sim/world/matter/surface.h"
#include "sim/world/settings.h"
#include "sim/world/space/collider_grid.h"
#include "sim/world/space/region.h"

/// Plain data that describes a world before it is uploaded to the GPU.
///
/// Conventions, valid everywhere: SI units, right-handed, +Y up, quaternions stored xyzw (Eigen's order), angles in
/// radians, colours linear RGB in 0-1.
namespace knuckle {

using Eigen::Quaternionf;
using Eigen::Vector3f;

/// What particles are made of.
struct Material {
    std::string name;
    float density = 1000.0f;       ///< [kg/m3], > 0. A particle of a body weighs density * diameter^3, all those of a
                                   ///< ball or capsule density * its volume.
    float staticFriction = 0.5f;   ///< Coulomb's mu while sticking, >= 0. A contact takes both sides' mean.
    float kineticFriction = 0.5f;  ///< Coulomb's mu while sliding, 0 ... staticFriction.
    /// Speed after a collision over the speed before it, 0 ... 1. A contact takes the larger of both sides'.
    float restitution = 0.0f;
    /// Rolling resistance, >= 0. Balls and capsules do not start to roll on a slope below its arc tangent; grains have
    /// it besides their static friction (matter/grain.h).
    float rollingFriction = 0.0f;
    Vector3f color{0.8f, 0.8f, 0.8f};  ///< Linear RGB, 0-1, used when colouring by material.
    bool fluid = false;                ///< Its particles are loose and flow.
    float viscosity = 0.001f;          ///< Fluids: dynamic [Pa s], >= 0. Water 0.001, honey 10.
    float slip = 0.0f;                 ///< Fluids: slip length at walls and solids [m], >= 0; thin ones always slip.
    float surfaceTension = 0.0f;       ///< Fluids: of their free surface [N/m], >= 0. Water 0.073.
    FluidLook look = {};               ///< Fluids: how they are drawn. Others: only what is drawn of them.
    Elasticity elasticity = {};        ///< Of soft bodies.
    SurfaceFinish finish = {};         ///< All but fluids: only how it is drawn.
};

struct Particle {
    Vector3f position{0, 0, 0};    ///< [m]
    Vector3f velocity{0, 0, 0};    ///< [m/s]
    float mass = 1.0f;             ///< [kg], > 0. Ignored in a fixed body.
    uint32_t material = 0;         ///< Index into World::materials.
    uint32_t body = NO_INDEX;      ///< The first body it belongs to, NO_INDEX for loose particles.
    uint32_t bodyCount = 0;        ///< Number of bodies that share it: 0 loose, 1 ordinary, 2 or more a joint.
    uint32_t assembly = NO_INDEX;  ///< Index of the set of bodies connected by joints, or of a soft body.
    /// Place in the rest pose of its assembly [m]. Two particles of one assembly that are nearer than a diameter there
    /// never touch (physics: self-collision filtered by rest distance).
    Vector3f restPosition{0, 0, 0};
    /// False for the cross of a universal joint, which the bodies around it would otherwise stop at once.
    bool touchesAssembly = true;
    /// Adds to the distance at rest below which it never touches another particle of its assembly [diameters], >= 0, so
    /// that the flesh around an actor's joints folds instead of holding the joint open.
    float selfMargin = 0.0f;
    bool pinned = false;      ///< A loose particle, of a soft body, that stays in place.
    float scale = 1.0f;       ///< Of a loose particle: its contacts' diameter over World's, 0.8 ... 1.2.
    SurfaceDistance surface;  ///< In its body; only used if bodyCount is 1.
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
    Fixed,     ///< Stays in place, for ever or until Body::releaseTime; its particles have infinite mass.
    Animated,  ///< Moves as a clip says until Body::releaseTime, and answers to nothing.
};

/// A ball or a capsule along y about the origin of the rest pose: contacts meet its surface, not its particles.
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
    float releaseTime = std::numeric_limits<float>::infinity();  ///< If not dynamic, when it is let go [s], >= 0.
    bool watched = false;                                        ///< One of World::releases may let go of it before, or
                                                                 ///< a release after it was caught.
    bool absent = false;                                  ///< Fixed only: nothing meets or sees it before it is let go.
    Vector3f throwVelocity{0, 0, 0}, throwSpin{0, 0, 0};  ///< Fixed only: how it is let go [m/s], [rad/s].
    uint32_t material = 0;
    uint32_t assembly = NO_INDEX;
    uint32_t linkStart = 0, linkCount = 0;
    uint32_t object = NO_INDEX;  ///< Index into World::objects: what the scene calls one thing.
    RoundShape round;            ///< Radius 0 for any other body.
    bool isCross = false;        ///< The flat middle body of a universal joint.
    /// Bodies of its object that it never touches, in both directions: the one that it hangs on if limits hold it, and
    /// those that it overlaps in most of a clip.
    std::vector<uint32_t> filtered;
    float mass = 0.0f;                 ///< Sum of its particles' shares of mass [kg].
    Vector3f restCentre{0, 0, 0};      ///< Mass centre in the object's rest pose [m].
    Vector3f position{0, 0, 0};        ///< Where restCentre starts [m].
    Quaternionf rotation{1, 0, 0, 0};  ///< Of the rest pose at the start.
};

/// One thing of the scene: a ragdoll, a jointed pair, a single rigid body. Used for names in exports and for cameras.
struct Object {
    std::string name;
    uint32_t bodyStart = 0, bodyCount = 0;

    uint32_t bodyEnd() const { return bodyStart + bodyCount; }
    bool has(uint32_t body) const { return body >= bodyStart && body < bodyEnd(); }
};

/// Particles without a body that one object of the scene is made of: grains, a rope, cloth, a fluid. Only a name.
struct LooseGroup {
    std::string name;
    uint32_t first = 0, end = 0;  ///< Particles.
    bool visible = true;
};

/// An obstacle: it stays in place, or moves as World::colliderMotions say, and answers to nothing.
struct Collider : Region {
    uint32_t grid = NO_INDEX;  ///< Mesh and heightfield: index into World::colliderGrids.
    float staticFriction = 0.5f;
    float kineticFriction = 0.5f;
    Vector3f color{0.45f, 0.47f, 0.5f};
    bool visible = true;  ///< Walls of a container often act without being drawn.
    SurfaceFinish finish = {};
    FloorLook floor = FloorLook::Default;  ///< Planes only.
};

enum class ReleaseCause : uint32_t { Impulse, Touch, Region };

/// Lets go of bodies of an object when something happens to any of them. Of several releases, the first counts.
struct Release {
    ReleaseCause cause = ReleaseCause::Impulse;
    std::vector<uint32_t> bodies;  ///< Of one object; each with all that hangs on it, and not all of them dynamic.
    float impulse = 0.0f;          ///< Impulse: of contacts on one of them in a step [N s], > 0.
    uint32_t firstParticle = 0, endParticle = 0;  ///< Touch: one of these particles.
    bool driven = false;                          ///< A puppet's bodies are driven from then on, otherwise limp.
    Region region;  ///< Region: contains the centre of one of their particles; box, sphere or capsule.
};

/// Numbers of each particle that the solver keeps for pictures alone.
struct ShownQuantities {
    bool ages = false;           ///< Since it came into the scene.
    bool contactForces = false;  ///< Not by the paper's solver.
    bool operator==(const ShownQuantities&) const = default;
};

struct World {
    float particleRadius = 0.05f;  ///< [m], > 0; the same for all.
    Settings settings;
    std::vector<Material> materials;
    std::vector<Particle> particles;
    std::vector<Body> bodies;
    std::vector<Link> links;
    std::vector<Joint> joints;  ///< At most one per pair of bodies.
    std::vector<Gear> gears;
    std::vector<Object> objects;
    std::vector<LooseGroup> looseGroups;
    std::vector<BodyClip> clips;
    std::vector<Animation> animations;
    std::vector<Puppet> puppets;
    std::vector<Release> releases;
    std::vector<Collider> colliders;              ///< At their first places.
    std::vector<ColliderMotion> colliderMotions;  ///< In the order of colliders.
    std::vector<SoftBody> softBodies;
    std::vector<Cluster> clusters;                        ///< Grouped by soft body.
    std::vector<Link> clusterLinks;                       ///< Grouped by cluster, whose index is in Link::body here.
    std::vector<Strand> strands;                          ///< Ropes and cloth.
    std::vector<std::array<uint32_t, 3>> clothTriangles;  ///< Particles at the corners of cloth's triangles, on which
                                                          ///< the air acts.
    std::vector<ColliderGrid> colliderGrids;
    std::vector<Skin> skins;            ///< Only drawn.
    std::vector<BodyShape> bodyShapes;  ///< Only drawn.
    DrawnMatter drawn;                  ///< Only drawn.
    std::vector<ParticleRange> unseen;  ///< Not drawn, and nothing that an automatic camera looks at.
    uint32_t assemblyCount = 0;
    /// Rest distance of fluid particles [m], 0.3 ... 0.6 diameters. A fluid particle weighs density * spacing^3.
    float fluidSpacing = 0.05f;
    uint32_t fluidCount = 0;  ///< Fluid particles; they come after all others in `particles`.
    ShownQuantities shown;
    /// Their pools are the last of the fluid particles, in this order; particles in a pool are inactive.
    std::vector<Emitter> emitters;
    std::vector<Region> drains;  ///< Fluids vanish in them; planes, boxes, spheres, capsules.
    std::optional<Wind> wind;    ///< None: no air.
    std::vector<ForceField> forceFields;

    /// Number of particles in the pools at the start.
    uint32_t pooledCount() const;
    /// Particles that are not fluid.
    uint32_t solidCount() const { return static_cast<uint32_t>(particles.size()) - fluidCount; }
    float diameter() const { return 2.0f * particleRadius; }
};

/// Whether a particle is fixed at first: it is pinned, or belongs to a fixed body.
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

/// Whether a held or animated body is, or may be, let go.
inline bool mayBeLetGo(const Body& body)
{
    return body.motion != Motion::Dynamic &&
           (body.watched || body.releaseTime < std::numeric_limits<float>::infinity());
}

/// Whether a held body is let go otherwise than from rest, where it is.
inline bool isThrown(const Body& body)
{
    return body.absent || !body.throwVelocity.isZero(0) || !body.throwSpin.isZero(0);
}

/// Where an absent body waits, far from all others and above all planes that are not far up [m].
inline Vector3f awayFrom(const World& world, const Body& body)
{
    constexpr float APART = 100.0f, UP = 1e5f;
    return body.absent ? Vector3f(APART * static_cast<float>(&body - world.bodies.data()), UP, 0) : Vector3f::Zero();
}

/// Whether a body never answers to anything: joints and ropes are planned as if all other bodies always did.
inline bool neverResponds(const Body& body)
{
    return body.motion == Motion::Fixed && !mayBeLetGo(body);
}

/// Whether a particle never moves: it is pinned, or belongs to a body that never responds.
inline bool isFixedForEver(const World& world, const Particle& particle)
{
    return particle.pinned || (particle.body != NO_INDEX && neverResponds(world.bodies[particle.body]));
}

/// Fluid does not begin nearer to a solid particle than this [m].
float fluidClearance(const World& world);

/// Checks every invariant that the solver relies on: indices in range, links grouped by body, finite positions,
/// positive masses, shared particles consistent with the links. Worlds of any origin are checked here alone.
/// @throws InputError for the first failure if a scene file can cause it, else std::logic_error.
void validate(const World& world);

}  // namespace knuckle
