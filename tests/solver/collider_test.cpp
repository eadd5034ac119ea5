#include <algorithm>
#include <cmath>

#include "sim/solver/measure.h"
#include "solver_test.h"

namespace knuckle::test {

namespace {

Collider colliderOf(ColliderShape shape, const Vector3f& position = {0, 0, 0}, const Quaternionf& turn = {1, 0, 0, 0})
{
    Collider c;
    c.shape = shape;
    c.position = position;
    c.orientation = turn;
    c.halfExtents = {0.3f, 0.1f, 0.2f};
    c.radius = 0.15f;
    c.halfHeight = 0.2f;
    return c;
}

/// One of each shape, turned and shifted, where particles are.
World colliderWorld()
{
    World world = mixedWorld();
    Random random(51);
    for (ColliderShape shape :
         {ColliderShape::Plane, ColliderShape::Box, ColliderShape::Sphere, ColliderShape::Capsule})
        world.colliders.push_back(colliderOf(shape, random.inCube(0.2f), random.rotation()));
    return world;
}

/// Places up to half a metre and sums of three products: 16 roundings of 2^-24 of a metre.
constexpr float ROUNDING = 1e-6f;

}  // namespace

TEST(ColliderDistance, IsThatOfTheShapeInItsOwnFrame)
{
    const struct { ColliderShape shape; Vector3f point; float distance; } rows[] = {
        {ColliderShape::Plane, {5, 0.25f, -3}, 0.25f},
        {ColliderShape::Plane, {5, -0.25f, -3}, -0.25f},
        {ColliderShape::Box, {0.4f, 0, 0}, 0.1f},               // off a face
        {ColliderShape::Box, {0.6f, 0.5f, 0}, 0.5f},            // off an edge: 3-4-5
        {ColliderShape::Box, {0.5f, 0.2f, 0.4f}, 0.3f},         // off a corner: 2-1-2
        {ColliderShape::Box, {0.1f, 0.04f, 0}, -0.06f},         // inside, under the nearest face
        {ColliderShape::Sphere, {0.3f, 0, 0.4f}, 0.35f},
        {ColliderShape::Sphere, {0, 0, 0}, -0.15f},
        {ColliderShape::Capsule, {0.2f, 0.1f, 0}, 0.05f},       // beside the shaft
        {ColliderShape::Capsule, {0, -0.5f, 0}, 0.15f},         // below the lower cap
        {ColliderShape::Capsule, {0.3f, 0.6f, 0}, 0.35f},       // off the upper cap: 3-4-5
    };
    const Vector3f place(0.5f, -1, 2);
    const Quaternionf turn(Eigen::AngleAxisf(1.1f, Vector3f(1, 1, 0).normalized()));
    for (const auto& row : rows) {
        EXPECT_NEAR(colliderDistance(colliderOf(row.shape), row.point), row.distance, ROUNDING);
        EXPECT_NEAR(colliderDistance(colliderOf(row.shape, place, turn), turn * row.point + place), row.distance,
                    4 * ROUNDING) << "turned";
    }
}

TEST(ColliderDistance, TheKernelsSeeTheSameDistanceAndItsGradient)
{
    std::filesystem::create_directories(shaderFolder().path("sim"));
    shaderFolder().write("sim/test_collider.comp", R"(#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
layout(local_size_x = GROUP_SIZE) in;
layout(location = 0) uniform uint index;
uniform samplerBuffer positions;
BUFFER(vec4, Moved, moved);
void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < step.particleCount) moved[i] = colliderDistance(index, texelFetch(positions, int(i)).xyz);
}
)");
    Bench bench(colliderWorld());
    const auto positions = randomVectors(bench.world.particles.size(), 0.5f, 52);
    fill(bench.buffers.positions, positions);
    const Kernel kernel = bench.load("test_collider");
    for (uint32_t c = 0; c < bench.world.colliders.size(); ++c) {
        SCOPED_TRACE("collider " + std::to_string(c));
        glProgramUniform1ui(kernel.program(), 0, c);
        bench.dispatch(kernel, groupsFor(positions.size()));
        const auto results = bench.buffers.moved.download();
        const auto distance = [&](const Vector3f& x) { return colliderDistance(bench.world.colliders[c], x); };
        uint32_t smooth = 0;
        for (size_t i = 0; i < positions.size(); ++i) {
            const Vector3f x = vec3(positions[i]), normal = vec3(results[i]);
            ASSERT_NEAR(results[i].w, distance(x), 4 * ROUNDING) << "particle " << i;
            ASSERT_NEAR(normal.norm(), 1.0f, 1e-5f) << "particle " << i;
            // A millimetre along the normal is a millimetre further out, but across an inner edge of a box.
            const float gained = distance(x + 0.001f * normal) - distance(x);
            smooth += std::abs(gained - 0.001f) < 1e-5f;
        }
        EXPECT_GT(smooth, 0.98 * static_cast<double>(positions.size()));
    }
    gpu().checkErrors();
}

TEST(ColliderFind, ListsTheCollidersThatAParticleMayTouch)
{
    Bench bench(colliderWorld());
    const uint32_t count = bench.buffers.parameters.particleCount, slots = bench.buffers.parameters.contactSlots;
    const auto places = randomVectors(count, 0.5f, 53);
    fill(bench.buffers.foundPositions, places);
    bench.forParticles("collider_find");
    const auto counts = bench.buffers.candidateCounts.download();
    const auto candidates = bench.buffers.candidates.download();
    const float reach = bench.buffers.parameters.contactRadius - DIAMETER / 2;
    uint32_t several = 0;
    for (uint32_t i = 0; i < count; ++i) {
        std::vector<uint32_t> found;
        for (uint32_t s = 0; s < counts[i].y; ++s) found.push_back(candidates[(slots + s) * count + i]);
        for (uint32_t c = 0; c < bench.world.colliders.size(); ++c) {
            const float distance = colliderDistance(bench.world.colliders[c], vec3(places[i]));
            if (std::abs(distance - reach) < 4 * ROUNDING) continue;
            const auto times = std::count(found.begin(), found.end(), c);
            EXPECT_EQ(times, distance < reach ? 1 : 0) << "particle " << i << ", collider " << c;
        }
        several += found.size() > 1;
    }
    EXPECT_GT(several, 20u);
    EXPECT_EQ(bench.counters().problems, 0u);
}

TEST(ColliderFind, MoreCollidersThanSlotsAreReported)
{
    World world = mixedWorld();
    world.colliders.assign(COLLIDER_SLOTS + 2, colliderOf(ColliderShape::Plane));
    Bench bench(std::move(world));
    bench.forParticles("collider_find");   // found positions are zero: all on every plane
    EXPECT_EQ(bench.counters().problems, PROBLEM_COLLIDERS);
    EXPECT_EQ(bench.counters().wantedColliders, COLLIDER_SLOTS + 2u);
    const auto counts = bench.buffers.candidateCounts.download();
    for (uint32_t i = 0; i < bench.buffers.parameters.particleCount; ++i)
        ASSERT_EQ(counts[i].y, uint32_t(COLLIDER_SLOTS)) << "particle " << i;
}

}  // namespace knuckle::test
