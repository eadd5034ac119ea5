#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// How the two bodies of a joint meet. All positions in the frame in which the bodies were added (the rest pose).
struct JointSpec {
    JointType type = JointType::Ball;
    std::string name;
    Vector3f anchor{0, 0, 0};  ///< Where the joint sits [m].
    Vector3f axis{0, 0, 1};    ///< Hinge: its axis. Universal: the axis of the hinge at the parent.
    Vector3f along{1, 0, 0};   ///< From parent to child, perpendicular to axis; fixed up if it is not.
    /// Hinge: which side of the plane of axis and `along` is blocked by limiting particles: +1 (the side of
    /// along x axis), -1 (the other) or 0 (free on both sides).
    int limitSide = 0;
    JointLimits limits;
    JointStrength strength;
};

/// Builds a World: bodies from particle positions, joints by sharing particles (paper, section 4), colliders.
///
/// Indices handed out stay valid. Bodies, joints and particles are added in the rest pose of their object, then
/// placed as a whole: beginObject(), addBody()..., addJoint()..., endObject(pose, velocity). A call out of this order,
/// or with an index of nothing, is a std::logic_error.
class WorldBuilder {
public:
    /// @param particleRadius [m], > 0.
    explicit WorldBuilder(float particleRadius, const Settings& settings = {});

    uint32_t addMaterial(Material material);
    void addCollider(const Collider& collider);
    /// From the start the last `count` colliders move together as a clip says, beginning where that has them at 0.
    /// @param pose of the frame that moves, where they stand.
    void moveColliders(uint32_t count, const Pose& pose, const ClipPlay& play);
    /// @returns its index, for Collider::grid.
    uint32_t addColliderGrid(ColliderGrid grid);

    /// Objects that are there wear a mesh, which moves with their bodies.
    void addSkin(const std::shared_ptr<const SkinMesh>& mesh, std::span<const uint32_t> objects, SkinUse use);

    /// All bodies and joints up to endObject() belong to one object named `name`.
    void beginObject(std::string name);
    /// A rigid body of particles at `positions` (rest pose of the object) [m]. `surface`: of each particle; where it is
    /// empty, a box lattice has a box's, and anything else none. `round`: the ball or capsule that they fill, by whose
    /// volume it weighs. @returns the body's index.
    /// @throws std::logic_error for an empty span or a position that is not finite.
    uint32_t addBody(std::string name, std::span<const Vector3f> positions, uint32_t material,
                     Motion motion = Motion::Dynamic, std::span<const SurfaceDistance> surface = {},
                     const RoundShape& round = {});
    /// Holds a body where it is put, for ever or until a time [s], when it is let go from rest.
    void holdBody(uint32_t body, float releaseTime = std::numeric_limits<float>::infinity());
    /// @returns its index, for ClipPlay::clip.
    uint32_t addClip(BodyClip clip);
    /// From the start the bodies of an object that is there move as its clips say. Their joints form a tree.
    void animate(Animation animation);
    /// Drives an animated object to its clips while it responds.
    void drive(Puppet puppet) { world_.puppets.push_back(std::move(puppet)); }
    /// Lets go of a body at a time [s], once more if that is after it was caught. @param driven whether a puppet's is
    /// driven from then on, or limp.
    void letGo(uint32_t body, float time, bool driven);
    /// Lets go of a body that is held or animated at a time [s].
    void releaseBody(uint32_t body, float time);
    /// Lets go of bodies that are held or animated when something happens to them.
    void addRelease(Release release);
    /// A soft body of particles at `positions` (rest pose of the object) [m], as elastic as its material.
    /// @param pinned indices into `positions`: these particles stay where they are put.
    /// @returns the soft body's index. @throws std::logic_error for an empty span or a position that is not finite.
    uint32_t addSoftBody(std::string name, std::span<const Vector3f> positions, uint32_t material,
                         std::span<const uint32_t> pinned = {});
    /// Joins two bodies by particles shared between them. Particles of either within half a diameter of a place the
    /// joint needs become the shared ones; elsewhere new particles are made.
    void addJoint(uint32_t parent, uint32_t child, const JointSpec& spec);
    /// Makes an existing particle part of one more body: the paper's joint itself.
    void shareParticle(uint32_t particle, uint32_t body);
    /// Says what is known of a joint that is made by shareParticle(); build() finds its particles and frames.
    void describeJoint(JointDraft draft);
    /// Particle::selfMargin for all particles of the open object [diameters].
    void setSelfMargin(float margin);
    /// The body is the cross of a universal joint: its particles touch no other of their assembly, and it has most of
    /// the mass of those that it shares.
    void markCross(uint32_t body);
    /// Two bodies of one object never touch (Body::passes).
    void passThrough(uint32_t body, uint32_t other);
    /// Places the open object; `velocity` [m/s] and `spin` [rad/s] about its mass centre. @returns the object's index.
    uint32_t endObject(const Pose& pose = {}, const Vector3f& velocity = {0, 0, 0}, const Vector3f& spin = {0, 0, 0});
    /// A particle of no body: a grain. @returns its index.
    uint32_t addLooseParticle(const Particle& particle);
    /// Distances between particles that exist: see addRope() and addCloth().
    void addStrand(Strand row);

    /// Fluid particles of a fluid material. They come behind all others, whenever they are added; build() leaves out
    /// those that overlap other particles.
    void addFluid(std::span<const Vector3f> positions, const Vector3f& velocity, uint32_t material);
    /// Sets the rest distance of fluids [diameters], 0.3 ... 0.6. To be called before addFluid().
    void setFluidSpacing(float spacing);
    float fluidSpacing() const { return world_.fluidSpacing; }
    /// Its pool comes behind all fluids. @throws std::logic_error unless its material is a fluid.
    void addEmitter(Emitter emitter);
    /// A plane, box, sphere or capsule in which fluids vanish.
    void addDrain(const Collider& region) { world_.drains.push_back(region); }
    const Material& material(uint32_t index) const { return world_.materials.at(index); }

    uint32_t particleCount() const { return static_cast<uint32_t>(world_.particles.size()); }
    uint32_t fluidCount() const { return static_cast<uint32_t>(fluid_.size()); }
    float diameter() const { return world_.diameter(); }
    /// What a particle of a material weighs: density times diameter cubed [kg].
    float particleMass(uint32_t material) const;
    /// The particles that a body was given so far and shares with no other.
    std::vector<uint32_t> ownParticles(uint32_t body) const;
    /// The world built so far: particles are placed, links and assemblies are not made before build().
    const World& world() const { return world_; }

    /// Groups links by body, fills centres, masses and assemblies, and validates. The builder is spent afterwards.
    World build();

private:
    uint32_t newParticle(const Vector3f& position, uint32_t material);
    /// As newParticle for each. @throws std::logic_error for what addBody() and addSoftBody() refuse.
    std::vector<uint32_t> newParticles(const std::string& name, std::span<const Vector3f> positions, uint32_t material);
    uint32_t findOrCreate(const Vector3f& position, uint32_t bodyA, uint32_t bodyB);
    void shareAt(std::span<const Vector3f> places, uint32_t bodyA, uint32_t bodyB);
    void addUniversal(uint32_t parent, uint32_t child, const JointSpec& spec);
    /// World::joints, once links are made: what is shared by whom, and what was said of it.
    void recordJoints();
    /// Puts what is animated where its clips begin, with the velocity that they have there.
    void poseAnimated(const Animation& animation);
    /// As linksOf(), before build() records the joints.
    std::vector<AnimatedLink> draftedLinks(const Animation& animation) const;
    void requireObject(const char* what) const;
    void assignAssemblies();
    void placeFluid();
    void requireFluid(const char* what, uint32_t material) const;
    Particle fluidParticle(uint32_t material) const;
    /// Balls and capsules weigh density times volume. Not among fluids, in which they displace their particles' cells.
    void weighRounds();
    void makeBodyLinks(uint32_t bodyIndex);
    /// The part of a particle's mass that counts in one of its bodies, 0 ... 1.
    float massFraction(uint32_t particle, uint32_t body) const;

    World world_;
    std::vector<std::vector<uint32_t>> bodyParticles_;  ///< Per body, the particles in its block, in order.
    std::vector<std::vector<uint32_t>> owners_;         ///< Per particle, its bodies.
    std::vector<JointDraft> joints_;
    bool choosesSubsteps_ = false;  ///< Settings::substeps was 0.
    std::vector<Particle> fluid_;
    bool objectOpen_ = false;
    uint32_t objectFirstParticle_ = 0;
};

/// Lattice points of a box of `counts` particles an axis, spaced by `diameter`, centred on the origin [m].
std::vector<Vector3f> boxLattice(const Eigen::Vector3i& counts, float diameter);
/// Lattice points inside a sphere whose surface lies at `radius` from the origin [m].
std::vector<Vector3f> sphereLattice(float radius, float diameter);
/// Lattice points inside a capsule along y; `halfHeight` between the centre and a cap's centre [m].
std::vector<Vector3f> capsuleLattice(float radius, float halfHeight, float diameter);

}  // namespace knuckle
