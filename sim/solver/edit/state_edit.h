#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "shared/gpu_types.h"
#include "sim/solver/layout/layout.h"
#include "sim/solver/stages_state.h"
#include "sim/world/world.h"

namespace knuckle {

/// How a rigid whole moves.
struct RigidVelocity {
    Vector3f velocity{0, 0, 0};  ///< Of `about` [m/s].
    Vector3f spin{0, 0, 0};      ///< [rad/s]
    Vector3f about{0, 0, 0};     ///< [m]

    Vector3f at(const Vector3f& place) const { return velocity + spin.cross(Vector3f(place - about)); }
};

/// Changes a state between two steps: where bodies are, how they and loose particles move, and what is let go. What is
/// changed wakes, with all of its assembly, and contacts are looked for anew.
class StateEdit {
public:
    /// @param layout of the world. @param state of its stages; it changes with commit().
    StateEdit(const World& world, const Layout& layout, StagesState& state);

    /// Whether impulses would move a body now: it is neither held nor follows a clip. Only these can be changed.
    bool responds(uint32_t body) const;
    /// Lets go of a held body before anything else, as of one that is not there yet, so that it can be changed at once.
    /// @returns false, and changes nothing, if it is held for ever or follows a clip.
    bool freeNow(uint32_t body);
    /// From a body's axes at rest, with the origin in its mass centre, to the world.
    Eigen::Isometry3f pose(uint32_t body) const;
    /// Moves bodies as one, with the particles that are theirs alone. Their velocities in the world stay.
    void move(std::span<const uint32_t> bodies, const Eigen::Isometry3f& motion);
    /// Gives bodies and their particles a velocity, @param added  to what they have, otherwise in its place.
    void setVelocity(std::span<const uint32_t> bodies, const RigidVelocity& given, bool added = false);
    /// Of a particle without a body; a pinned one keeps still.
    void setParticleVelocity(uint32_t particle, const Vector3f& velocity);
    /// @param impulse on a body [N s]. @param at  where [m].
    void push(uint32_t body, const Vector3f& impulse, const Vector3f& at);
    /// Spreads an impulse over particles without bodies, first ... end - 1, nearer to a place than `radius` [m].
    /// @param impulse their sum [N s]. @returns false, and changes nothing, if there is none.
    bool stir(uint32_t first, uint32_t end, const Vector3f& impulse, const Vector3f& at, float radius);
    /// As after a change that everything feels.
    void wakeAll();
    /// Lets go of bodies that are held or follow a clip, in the next substep; those of puppets go limp.
    /// @returns false, and changes nothing, if one is held for ever.
    bool letGo(std::span<const uint32_t> bodies);
    void commit();

private:
    std::vector<uint32_t> particlesOf(std::span<const uint32_t> bodies) const;
    void beginAnew(uint32_t assembly);
    void wake(uint32_t mover, uint32_t assembly);
    void makeLimp(std::span<const uint32_t> bodies);

    const World& world_;
    const Layout& layout_;
    StagesState& state_;
    std::vector<gpu::vec4> positions_, velocities_, centres_, rotations_, fields_, impulses_;
    std::vector<uint32_t> movers_;
    std::vector<gpu::uvec2> assemblies_, calm_;
    uint32_t substep_;  ///< Done so far.
};

}  // namespace knuckle
