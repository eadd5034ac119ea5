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
    /// Smooths with materials' parts `all`, `even` of which spares even changes.
    std::vector<gpu::vec4> smoothed(float all, float even)
    {
        auto materials = fixture.stages.fluids->fluidMaterials.download();
        for (gpu::vec4& m : materials) m.x = all - even;
        fill(fixture.stages.fluids->fluidMaterials, materials);
        fixture.stages.parameters.evenSmoothing = even;
        fixture.stages.uploadParameters();
        for (const char* kernel : {"fluid_gather", "fluid_velocity_gradient", "fluid_viscosity"})
            fixture.forSlots(std::string("fluid/") + kernel);
        return fixture.stages.particles.velocities.download();
    }
    /// Of the velocities around it, without its trace [1/s].
    Matrix3d gradient(uint32_t i) const
    {
        Matrix3d slope = Matrix3d::Zero(), moment = Matrix3d::Zero();
        double share = fixture.share(0.0);
        for (uint32_t j : fixture.fluidNear(i)) {
            const Vector3d r = fixture.place(j) - fixture.place(i);
            share += fixture.share(r.norm());
            const Vector3d weight = -fixture.slope(r.norm()) * r.normalized();
            slope += (velocity(j) - velocity(i)) * weight.transpose();
            moment += r * weight.transpose();
        }
        const double lacking = 0.1 * std::max(1.0 - share, 0.0) + 0.005;
        const Matrix3d all = slope * (moment + lacking * Matrix3d::Identity()).inverse();
        return all - all.trace() / 3.0 * Matrix3d::Identity();
    }
    /// A cloud whose fluid lies on the lattice of fluid at rest, and its particles far enough inside.
    std::vector<uint32_t> makeLattice()
    {
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
        return inside;
    }
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
    // A thick oil is solved implicitly.
    EXPECT_EQ(fixture.stages.fluids->fluidMaterials.download()[2].x, -1.0f);
    constexpr float ALL = 0.5f, EVEN = 0.2f;
    const auto found = smoothed(ALL, EVEN);
    std::vector<Matrix3d> gradients(fixture.count());
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) gradients[i] = gradient(i);
    Vector3d sum = Vector3d::Zero();
    double size = 0.0, energy = 0.0;
    for (uint32_t i = fixture.solidCount(); i < fixture.count(); ++i) {
        Vector3d change = Vector3d::Zero();
        for (uint32_t j : fixture.fluidNear(i)) {
            const double lighter = fixture.mass(j) / (fixture.mass(i) + fixture.mass(j));
            const Vector3d r = fixture.place(j) - fixture.place(i);
            const Vector3d apart = velocity(j) - velocity(i);
            const Vector3d uneven = apart - 0.5 * (gradients[i] + gradients[j]) * r;
            const double flow = uneven.squaredNorm() / std::pow(fixture.parameters().quietSpeed, 2);
            change += lighter * fixture.share(r.norm()) * 2.0 * ((ALL - EVEN) * apart + EVEN * uneven / (1.0 + flow));
        }
        const Vector3d now = vec3(found[i]).cast<double>(), got = now - velocity(i);
        ASSERT_LT((got - change).norm(), 2e-3 * (1.0 + change.norm())) << i;  // gradients are halves
        sum += fixture.mass(i) * got;
        size += fixture.mass(i) * got.norm();
        energy += fixture.mass(i) * (now.squaredNorm() - velocity(i).squaredNorm());
    }
    EXPECT_LT(sum.norm(), ROUNDING * size);
    EXPECT_LT(energy, -0.05 * size);
    for (uint32_t i = 0; i < fixture.solidCount(); ++i) ASSERT_EQ(vec3(found[i]), vec3(velocities[i])) << i;
}

TEST_F(FluidViscosity, WhatTurnsOrShearsEvenlyIsSpared)
{
    const std::vector<uint32_t> inside = makeLattice();
    const Eigen::Matrix3f slope = (Eigen::Matrix3f() << 1, 2, -3, 4, -3, 5, -6, 7, 2).finished();
    auto flow = fixture.places;
    for (gpu::vec4& v : flow) v = packed(slope * vec3(v));
    setVelocities(flow);
    const auto found = smoothed(0.5f, 0.5f);
    const float most = slope.norm() * fixture.parameters().fluidSpacing;
    for (uint32_t i : inside) ASSERT_LT((vec3(found[i]) - vec3(flow[i])).norm(), 0.01f * most) << i;
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
    const std::vector<uint32_t> inside = makeLattice();
    const Vector3f spin(1.0f, -2.0f, 3.0f);
    auto turning = fixture.places;
    for (gpu::vec4& v : turning) v = packed(spin.cross(vec3(v)));
    setVelocities(turning);
    const auto found = vorticities();
    // A few dozen neighbours make up 0.96 of the integral of r grad W; the rest is rounding.
    double moment = 0.0;
    for (uint32_t j : fixture.fluidNear(inside.front())) {
        const double r = (fixture.place(j) - fixture.place(inside.front())).norm();
        moment -= fixture.slope(r) * r / 3.0;
    }
    EXPECT_NEAR(moment, 1.0, 0.05);
    const Vector3f wanted = 2.0f * static_cast<float>(moment) * spin;
    for (uint32_t i : inside) ASSERT_LT((vec3(found[i]) - wanted).norm(), 0.01f * spin.norm()) << vec3(found[i]);
}

}  // namespace

}  // namespace knuckle::test
