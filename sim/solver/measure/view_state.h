#pragma once

#include <cstdint>
#include <vector>

#include "shared/vector_types.h"
#include "sim/solver/measure/state.h"
#include "sim/world/world.h"

namespace knuckle {

/// What a renderer and exports read of a state, on the host, bit by bit; see ParticleView.
struct ViewState {
    std::vector<gpu::vec4> positions{};       ///< Of each particle: xyz [m], w: 0, or 1 for an inactive one.
    std::vector<gpu::vec4> velocities{};      ///< xyz [m/s].
    std::vector<gpu::vec4> bodyCentres{};     ///< Of each body: xyz [m].
    std::vector<gpu::vec4> bodyRotations{};   ///< Quaternions xyzw from the rest pose.
    std::vector<gpu::vec4> colliderPlaces{};  ///< Of each collider: xyz [m]; quaternion xyzw.
    std::vector<bool> torn{};                 ///< As ParticleState::torn.
    std::vector<gpu::vec4> foamPlaces{};      ///< Of points of foam: xyz [m], w: opacity, 0: none is there.
    std::vector<uint32_t> fluidForms{};       ///< Of each particle, packed (math/spheroid.glsl); empty: balls.
    std::vector<bool> tornDistances{};        ///< In the order of strandOrder(); empty: none can tear.
    std::vector<float> ages{};                ///< Of each particle, as of ParticleView; empty: World::shown has none.
    std::vector<float> contactForces{};       ///< The same.
};

/// The two sums of a state's hash as one number; see shaders/shared/state_hash.h.
inline uint64_t joinedHash(uint32_t low, uint32_t high)
{
    return uint64_t{high} << 32 | low;
}
/// The same hash as Solver::stateHash().
uint64_t stateHash(const ViewState& view);

/// @param view its positions, velocities and torn particles are enough.
ParticleState particleState(const ViewState& view);
/// As World::bodies.
std::vector<BodyState> bodyStates(const World& world, const ViewState& view);

}  // namespace knuckle
