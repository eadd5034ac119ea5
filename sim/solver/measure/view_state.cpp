#include "sim/solver/measure/view_state.h"

#include <bit>

#include "shared/state_hash.h"
#include "sim/solver/measure/measure.h"

namespace knuckle {

namespace {

std::vector<Vector3f> unpack(const std::vector<gpu::vec4>& values)
{
    std::vector<Vector3f> out;
    out.reserve(values.size());
    for (const gpu::vec4& v : values) out.emplace_back(v.x, v.y, v.z);
    return out;
}

}  // namespace

ParticleState particleState(const ViewState& view)
{
    ParticleState state{unpack(view.positions), unpack(view.velocities), {}, view.torn};
    state.inactive.reserve(view.positions.size());
    for (const gpu::vec4& position : view.positions) state.inactive.push_back(position.w != 0.0f);
    return state;
}

std::vector<BodyState> bodyStates(const World& world, const ViewState& view)
{
    const ParticleState particles = particleState(view);
    std::vector<BodyState> states;
    for (size_t b = 0; b < world.bodies.size(); ++b) {
        const gpu::vec4 &c = view.bodyCentres[b], &q = view.bodyRotations[b];
        states.push_back(
            bodyState(world, world.bodies[b], particles, {c.x, c.y, c.z}, Quaternionf(q.w, q.x, q.y, q.z)));
    }
    return states;
}

uint64_t stateHash(const ViewState& view)
{
    uint32_t low = 0, high = 0;
    for (uint32_t i = 0; i < view.positions.size(); ++i) {
        const gpu::vec4 &x = view.positions[i], &v = view.velocities[i];
        const auto hashOf = [&](uint32_t seed) {
            uint32_t hash = gpu::mixedHash(seed, i);
            for (const float value : {x.x, x.y, x.z, v.x, v.y, v.z})
                hash = gpu::mixedHash(hash, std::bit_cast<uint32_t>(value));
            return hash;
        };
        low += hashOf(STATE_HASH_LOW);
        high += hashOf(STATE_HASH_HIGH);
    }
    return joinedHash(low, high);
}

}  // namespace knuckle
