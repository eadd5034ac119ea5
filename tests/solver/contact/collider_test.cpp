#include <algorithm>
#include <cmath>

#include "sim/world/collider_distance.h"
#include "tests/solver/contact/collider_world.h"

namespace knuckle::test {

namespace {

/// Places up to half a metre and sums of three products: 16 roundings of 2^-24 of a metre.
constexpr float ROUNDING = 1e-6f;

}  // namespace

TEST(ColliderDistance, IsThatOfTheShapeInItsOwnFrame)
{
    const struct {
        ColliderShape shape;
        Vector3f point;
        float distance;
    } rows[] = {
        {ColliderShape::Plane, {5, 0.25f, -3}, 0.25f},    {ColliderShape::Plane, {5, -0.25f, -3}, -0.25f},
        {ColliderShape::Box, {0.4f, 0, 0}, 0.1f},        // off a face
        {ColliderShape::Box, {0.6f, 0.5f, 0}, 0.5f},     // off an edge: 3-4-5
        {ColliderShape::Box, {0.5f, 0.2f, 0.4f}, 0.3f},  // off a corner: 2-1-2
        {ColliderShape::Box, {0.1f, 0.04f, 0}, -0.06f},  // inside, under the nearest face
        {ColliderShape::Sphere, {0.3f, 0, 0.4f}, 0.35f},  {ColliderShape::Sphere, {0, 0, 0}, -0.15f},
        {ColliderShape::Capsule, {0.2f, 0.1f, 0}, 0.05f},  // beside the shaft
        {ColliderShape::Capsule, {0, -0.5f, 0}, 0.15f},    // below the lower cap
        {ColliderShape::Capsule, {0.3f, 0.6f, 0}, 0.35f},  // off the upper cap: 3-4-5
    };
    const Vector3f place(0.5f, -1, 2);
    const Quaternionf turn(Eigen::AngleAxisf(1.1f, Vector3f(1, 1, 0).normalized()));
    for (const auto& row : rows) {
        EXPECT_NEAR(colliderDistance({}, colliderOf(row.shape), row.point), row.distance, ROUNDING);
        EXPECT_NEAR(colliderDistance({}, colliderOf(row.shape, place, turn), turn * row.point + place), row.distance,
                    4 * ROUNDING)
            << "turned";
    }
}

TEST(ColliderDistance, TheKernelsSeeTheSameDistanceAndItsGradient)
{
    writeColliderKernel();
    KernelFixture fixture(colliderWorld());
    const auto positions = randomVectors(fixture.world.particles.size(), 0.5f, 52);
    fill(fixture.stages.particles.positions, positions);
    const Kernel kernel = fixture.load("test_collider");
    for (uint32_t c = 0; c < fixture.world.colliders.size(); ++c) {
        SCOPED_TRACE("collider " + std::to_string(c));
        glProgramUniform1ui(kernel.program(), 0, c);
        fixture.dispatch(kernel, groupsFor(positions.size()));
        const auto results = fixture.stages.particles.velocities.download();
        const auto distance = [&](const Vector3f& x) {
            return colliderDistance(fixture.world, fixture.world.colliders[c], x);
        };
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

}  // namespace knuckle::test
