#include <algorithm>
#include <cmath>

#include "tests/solver/fluid/fluid_bench.h"

namespace knuckle::test {

namespace {

constexpr double ROUNDING = 1e-5;

class FluidSmooth : public testing::Test {
protected:
    FluidSmooth() : bench(swirling()) {}
    static Settings swirling()
    {
        Settings settings;
        settings.vorticity = 0.1f;
        return settings;
    }
    void setVelocities(const std::vector<gpu::vec4>& values)
    {
        velocities = values;
        fill(bench.buffers.velocities, velocities);
        bench.forSlots("fluid/fluid_velocity");
    }
    Vector3d velocity(uint32_t i) const { return vec3(velocities[i]).cast<double>(); }
    std::vector<gpu::vec4> vorticities()
    {
        bench.forSlots("fluid/fluid_vorticity");
        return bench.byParticle(bench.buffers.fluid.slotVorticities.download());
    }

    FluidBench bench;
    std::vector<gpu::vec4> velocities;
};

TEST_F(FluidSmooth, VelocitiesEvenOutAndKeepTheirMomentum)
{
    bench.findNeighbours();
    setVelocities(randomVectors(bench.count(), 1.0f, 51));
    const auto strengths = bench.buffers.fluid.fluidMaterials.download();
    bench.forSlots("fluid/fluid_smooth");
    const auto found = bench.buffers.velocities.download();
    const auto strength = [&](uint32_t i) { return double(strengths[bench.world.particles[i].material].x); };
    EXPECT_GT(strengths[2].x, 2.0f * strengths[1].x);
    Vector3d sum = Vector3d::Zero();
    double size = 0.0, energy = 0.0;
    for (uint32_t i = bench.solidCount(); i < bench.count(); ++i) {
        Vector3d change = Vector3d::Zero();
        for (uint32_t j : bench.fluidNear(i)) {
            const double lighter = bench.mass(j) / (bench.mass(i) + bench.mass(j));
            change += (strength(i) + strength(j)) * lighter * bench.share((bench.place(i) - bench.place(j)).norm()) *
                      (velocity(j) - velocity(i));
        }
        const Vector3d now = vec3(found[i]).cast<double>(), got = now - velocity(i);
        ASSERT_LT((got - change).norm(), ROUNDING * (1.0 + change.norm())) << i;
        sum += bench.mass(i) * got;
        size += bench.mass(i) * got.norm();
        energy += bench.mass(i) * (now.squaredNorm() - velocity(i).squaredNorm());
    }
    EXPECT_LT(sum.norm(), ROUNDING * size);
    EXPECT_LT(energy, -0.05 * size);
    for (uint32_t i = 0; i < bench.solidCount(); ++i) ASSERT_EQ(vec3(found[i]), vec3(velocities[i])) << i;
}

TEST_F(FluidSmooth, TheSwirlOfACloudIsThatOfDoublePrecision)
{
    bench.findNeighbours();
    setVelocities(randomVectors(bench.count(), 1.0f, 52));
    const auto found = vorticities();
    for (uint32_t i = bench.solidCount(); i < bench.count(); ++i) {
        Vector3d swirl = Vector3d::Zero();
        double size = 1.0;
        for (uint32_t j : bench.fluidNear(i)) {
            const Vector3d r = bench.place(i) - bench.place(j);
            const Vector3d way = bench.slope(r.norm()) * r.normalized();
            swirl += way.cross(velocity(j) - velocity(i));
            size += way.norm();
        }
        ASSERT_LT((vec3(found[i]).cast<double>() - swirl).norm(), ROUNDING * size) << i;
        ASSERT_NEAR(found[i].w, swirl.norm(), ROUNDING * size) << i;
    }
}

TEST_F(FluidSmooth, WhatTurnsLikeASolidSwirlsTwiceAsFast)
{
    // On the lattice of fluid at rest, far enough inside; solids out of the way.
    const float s = bench.parameters().fluidSpacing;
    auto places = bench.places;
    std::vector<uint32_t> inside;
    uint32_t next = bench.solidCount();
    for (uint32_t i = 0; i < next; ++i) places[i] = packed({3, 0, 0});
    for (int z = -4; z <= 4; ++z)
        for (int y = -4; y <= 4; ++y)
            for (int x = -4; x <= 4; ++x, ++next) {
                places.at(next) = packed(s * Vector3f(float(x), float(y), float(z)));
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) <= 1) inside.push_back(next);
            }
    for (; next < bench.count(); ++next) places[next] = packed({-3.0f - float(next), 0, 0});
    bench.setPlaces(places);
    bench.findNeighbours();
    const Vector3f spin(1.0f, -2.0f, 3.0f);
    auto turning = places;
    for (gpu::vec4& v : turning) v = packed(spin.cross(vec3(v)));
    setVelocities(turning);
    const auto found = vorticities();
    for (uint32_t i : inside) ASSERT_LT((vec3(found[i]) - 2.0f * spin).norm(), 0.03f * spin.norm()) << vec3(found[i]);
}

}  // namespace

}  // namespace knuckle::test
