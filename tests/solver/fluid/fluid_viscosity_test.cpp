#include <algorithm>
#include <cmath>

#include "tests/solver/fluid/fluid_fixture.h"

namespace knuckle::test {

namespace {

constexpr double ROUNDING = 1e-5;

class FluidViscosity : public testing::Test {
protected:
    FluidViscosity() : fixture(swirling()) {}
    static Settings swirling()
    {
        Settings settings;
        settings.vorticity = 0.1f;
        return settings;
    }
    void setVelocities(const std::vector<gpu::vec4>& values)
    {
        velocities = values;
        fill(fixture.stages.particles.velocities, velocities);
        fixture.forSlots("fluid/fluid_gather");
    }
    Vector3d velocity(uint32_t i) const { return vec3(velocities[i]).cast<double>(); }
    std::vector<gpu::vec4> vorticities()
    {
        fixture.forSlots("fluid/fluid_vorticity");
        return fixture.byParticle(fixture.stages.fluids->slotVorticities.download());
    }

    FluidFixture fixture;
    std::vector<gpu::vec4> velocities;
};

TEST_F(FluidViscosity, VelocitiesEvenOutAndKeepTheirMomentum)
{
    fixture.findNeighbours();
    setVelocities(randomVectors(fixture.count(), 1.0f, 51));
    // As of a thick oil, which would be solved implicitly.
    auto strengths = fixture.stages.fluids->fluidMaterials.download();
    EXPECT_EQ(strengths[2].x, 0.0f);
    strengths[2].x = 0.5f;
    fill(fixture.stages.fluids->fluidMaterials, strengths);
    fixture.forSlots("fluid/fluid_gather");
    fixture.forSlots("fluid/fluid_viscosity");
    const auto found = fixture.stages.particles.velocities.download();
    const auto strength = [&](uint32_t i) { return double(strengths[fixture.world.particles[i].material].x); };
    Vector3d sum = Vector3d::Zero();
    double size = 0.0, energy = 0.0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        Vector3d change = Vector3d::Zero();
        for (uint32_t j : fixture.fluidNear(i)) {
            const double lighter = fixture.mass(j) / (fixture.mass(i) + fixture.mass(j));
            change += (strength(i) + strength(j)) * lighter *
                      fixture.share((fixture.place(i) - fixture.place(j)).norm()) * (velocity(j) - velocity(i));
        }
        const Vector3d now = vec3(found[i]).cast<double>(), got = now - velocity(i);
        ASSERT_LT((got - change).norm(), ROUNDING * (1.0 + change.norm())) << i;
        sum += fixture.mass(i) * got;
        size += fixture.mass(i) * got.norm();
        energy += fixture.mass(i) * (now.squaredNorm() - velocity(i).squaredNorm());
    }
    EXPECT_LT(sum.norm(), ROUNDING * size);
    EXPECT_LT(energy, -0.05 * size);
    for (uint32_t i = 0; i < fixture.solidCount(); ++i) ASSERT_EQ(vec3(found[i]), vec3(velocities[i])) << i;
}

TEST_F(FluidViscosity, TheSwirlOfACloudIsThatOfDoublePrecision)
{
    fixture.findNeighbours();
    setVelocities(randomVectors(fixture.count(), 1.0f, 52));
    const auto found = vorticities();
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        Vector3d swirl = Vector3d::Zero();
        double size = 1.0;
        for (uint32_t j : fixture.fluidNear(i)) {
            const Vector3d r = fixture.place(i) - fixture.place(j);
            const Vector3d way = fixture.slope(r.norm()) * r.normalized();
            swirl += way.cross(velocity(j) - velocity(i));
            size += way.norm();
        }
        ASSERT_LT((vec3(found[i]).cast<double>() - swirl).norm(), ROUNDING * size) << i;
        ASSERT_NEAR(found[i].w, swirl.norm(), ROUNDING * size) << i;
    }
}

TEST_F(FluidViscosity, WhatTurnsLikeASolidSwirlsTwiceAsFast)
{
    // On the lattice of fluid at rest, far enough inside; solids out of the way.
    const float s = fixture.parameters().fluidSpacing;
    auto places = fixture.places;
    std::vector<uint32_t> inside;
    uint32_t next = fixture.solidCount();
    for (uint32_t i = 0; i < next; ++i) places[i] = packed({3, 0, 0});
    for (int z = -4; z <= 4; ++z)
        for (int y = -4; y <= 4; ++y)
            for (int x = -4; x <= 4; ++x, ++next) {
                places.at(next) = packed(s * Vector3f(float(x), float(y), float(z)));
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) <= 1) inside.push_back(next);
            }
    for (; next < fixture.count(); ++next) places[next] = packed({-3.0f - float(next), 0, 0});
    fixture.setPlaces(places);
    fixture.findNeighbours();
    const Vector3f spin(1.0f, -2.0f, 3.0f);
    auto turning = places;
    for (gpu::vec4& v : turning) v = packed(spin.cross(vec3(v)));
    setVelocities(turning);
    const auto found = vorticities();
    for (uint32_t i : inside) ASSERT_LT((vec3(found[i]) - 2.0f * spin).norm(), 0.03f * spin.norm()) << vec3(found[i]);
}

}  // namespace

}  // namespace knuckle::test
