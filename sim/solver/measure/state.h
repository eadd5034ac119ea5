#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

struct ParticleState {
    /// Whether a joint has torn and the body has lost the link's particle.
    bool lost(const World& world, const Link& link) const
    {
        return !torn.empty() && torn[link.particle] && world.particles[link.particle].body != link.body;
    }

    std::vector<Vector3f> positions;   ///< [m]
    std::vector<Vector3f> velocities;  ///< [m/s]
    std::vector<bool> inactive;        ///< Fluid particles that no emitter has let out yet, or that a drain took.
    std::vector<bool>
        torn;  ///< Particles of torn joints, which stay with the first of their bodies. Empty: no joint can tear.
};

struct BodyState {
    Vector3f position{0, 0, 0};         ///< Mass centre [m].
    Quaternionf rotation{1, 0, 0, 0};   ///< From the body's axes at rest to the world.
    Vector3f velocity{0, 0, 0};         ///< Of the mass centre [m/s].
    Vector3f angularVelocity{0, 0, 0};  ///< About the mass centre [rad/s].
};

/// How well the state holds together. Depths and gaps in metres.
struct Measures {
    uint32_t contactCount = 0;     ///< Pairs of particles that overlap, each once, and particle-collider overlaps.
    float meanPenetration = 0.0f;  ///< Over the overlapping contacts.
    float worstPenetration = 0.0f;
    float meanJointGap = 0.0f;  ///< Distance between the places at which two bodies want a shared particle.
    float worstJointGap = 0.0f;
    float worstShapeError = 0.0f;  ///< Largest distance of a particle from the rigid motion of its body.
    float meanSoftStrain = 0.0f;   ///< Of clusters of soft bodies by mass: sqrt(sum of (principal stretch - 1)^2).
    float worstSoftStrain = 0.0f;
    float softVolumeError = 0.0f;   ///< The largest change of a soft body's volume, as a share of it.
    float meanDensityError = 0.0f;  ///< Of fluid particles: how much denser than at rest, as a share of that.
    float worstDensityError = 0.0f;
    float fluidVolumeError = 0.0f;  ///< The share of their volume that fluids have lost to that.
    uint32_t fluidCount = 0;        ///< Active fluid particles.
    uint32_t fluidEmitted = 0;      ///< Since the start, from all emitters.
    uint32_t fluidDrained = 0;      ///< Since the start, in drains or taken again as the oldest.
    float meanStretch = 0.0f;       ///< Of untorn ropes and threads of cloth: |length / length at rest - 1|.
    float worstStretch = 0.0f;
    float pinForce = 0.0f;         ///< The largest that a pin gives now [N].
    float pinTorque = 0.0f;        ///< [N m]
    float pinImpulse = 0.0f;       ///< Size of the sum of what all pins gave since the start [N s].
    float pinWork = 0.0f;          ///< Done by their forces since the start [J].
    uint32_t caughtCount = 0;      ///< Driven objects that are animated again.
    uint32_t knockedOutCount = 0;  ///< Driven objects that were let go by themselves.
    float maxSpeed = 0.0f;         ///< [m/s]
    double kineticEnergy = 0.0;    ///< [J]
};

}  // namespace knuckle
