#pragma once

#include "sim/solver/measure/state.h"

namespace knuckle {

/// Where a body is and how it moves, by its particles: velocity of the mass centre, angular velocity from the angular
/// momentum about it. @param centre, rotation of its shape match.
BodyState bodyState(const World& world, const Body& body, const ParticleState& particles, const Vector3f& centre,
                    const Quaternionf& rotation);

/// Contacts, gaps and energies of a state (all but ropes and cloth), on the host: checks every pair of particles that
/// may touch, independently of the solver's own lists.
Measures measureState(const World& world, const std::vector<Collider>& colliders, const ParticleState& particles,
                      const std::vector<BodyState>& bodies);

/// The worst gap of the joints of an object [m].
float worstJointGap(const World& world, const ParticleState& particles, const std::vector<BodyState>& bodies,
                    const Object& object);

/// Adds the measures of soft bodies, against their shape at the start.
void measureSoftBodies(Measures& out, const World& world, const ParticleState& particles);

/// Adds the measures of ropes and cloth. @param torn per distance of all rows, in their order (tornDistances).
void measureDistances(Measures& out, const World& world, const ParticleState& particles, const std::vector<bool>& torn);

/// Adds the measures of fluids. @param densities of their particles, over those at rest.
void measureFluids(Measures& out, const std::vector<std::pair<uint32_t, float>>& densities);

/// Whether two particles may touch: not of one body, and of one assembly only if they do not overlap at rest.
bool mayTouch(const World& world, uint32_t a, uint32_t b);

}  // namespace knuckle
