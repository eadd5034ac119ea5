#pragma once

#include <filesystem>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

inline Collider colliderOf(ColliderShape shape, const Vector3f& position = {0, 0, 0},
                           const Quaternionf& turn = {1, 0, 0, 0}, float size = 1.0f)
{
    Collider c;
    c.shape = shape;
    c.position = position;
    c.orientation = turn;
    c.halfExtents = size * Vector3f(0.3f, 0.1f, 0.2f);
    c.radius = size * 0.15f;
    c.halfHeight = size * 0.2f;
    return c;
}

/// Colliders of each shape, turned and shifted, at the places of particles. More than four are smaller and apart, so
/// that only the plane among them is near many particles.
inline World colliderWorld(uint32_t count = 4)
{
    World world = mixedWorld();
    Random random(51);
    const bool many = count > 4;
    for (uint32_t c = 0; c < count; ++c) {
        constexpr ColliderShape SHAPES[] = {ColliderShape::Box, ColliderShape::Sphere, ColliderShape::Capsule};
        const ColliderShape shape = c == count - 1 ? ColliderShape::Plane : SHAPES[c % 3];
        const Vector3f cell = Eigen::Vector3<uint32_t>(c % 5, c / 5 % 5, c / 25).cast<float>() - Vector3f(2, 2, 1);
        const Vector3f position = many ? 0.22f * cell + random.inCube(0.03f) : random.inCube(0.2f);
        world.colliders.push_back(colliderOf(shape, position, random.rotation(), many ? 0.25f : 1.0f));
        world.colliders.back().staticFriction = random.between(0.5f, 1.0f);
        world.colliders.back().kineticFriction = random.between(0.0f, 0.5f);
    }
    return world;
}

/// Makes `sim/test_collider.comp` write colliderSurface() of each position, for the collider in location 0, to
/// `velocities`.
inline void writeColliderKernel()
{
    std::filesystem::create_directories(shaderFolder().path("sim"));
    shaderFolder().write("sim/test_collider.comp", R"(#include "sim/common/kernel.glsl"
#include "sim/common/contacts/colliders.glsl"
layout(local_size_x = GROUP_SIZE) in;
layout(location = 0) uniform uint index;
uniform samplerBuffer positions;
BUFFER(vec4, Velocities, velocities);
void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    ColliderSurface surface = colliderSurface(index, texelFetch(positions, int(i)).xyz);
    velocities[i] = vec4(surface.normal, surface.distance);
}
)");
}

}  // namespace knuckle::test
