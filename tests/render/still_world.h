#pragma once

#include <vector>

#include "shared/gpu_types.h"
#include "sim/gpu/buffer.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle::test {

/// A world that never moves, built particle by particle, for pictures of known states.
class StillWorld {
public:
    explicit StillWorld(float radius);

    /// A body of particles at `offsets`, turned and put at `pose`. @returns its index.
    uint32_t addBody(const std::vector<Vector3f>& offsets, const Vector3f& position,
                     const Quaternionf& rotation = Quaternionf::Identity(),
                     const Vector3f& velocity = Vector3f::Zero());
    void addGround();
    Collider& addCollider(ColliderShape shape, const Vector3f& position);

    World world;
};

/// Its state in buffers like the solver's.
class StillBuffers {
public:
    /// @param forms of fluids, per particle, packed as by math/spheroid.glsl; empty: balls
    explicit StillBuffers(const World& world, const std::vector<uint32_t>& forms = {});
    ParticleView view() const;

private:
    float radius_, fluidSpacing_;
    uint32_t solidCount_;
    Buffer<gpu::vec4> positions_, velocities_, centres_, rotations_, places_;
    Buffer<uint32_t> forms_;
};

/// A form of StillBuffers. @param along, across  half lengths along the axis and across it, over the radius
uint32_t packedForm(const Vector3f& axis, double along, double across);

/// Adds fluid particles at `positions`, behind the particles that exist.
void addFluid(World& world, const std::vector<Vector3f>& positions);

/// Lattice points of a cube of `count` particles a side, spaced by `diameter`, centred on the origin [m].
std::vector<Vector3f> cubeLattice(int count, float diameter);

}  // namespace knuckle::test
