#include <cmath>
#include <numbers>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float SIZE = 0.02f;                                   ///< Of particles [m].
constexpr double POISSON = 0.3, DENSITY = 1000.0, SAG = 0.015;  // the latter over the length

enum class Load { Beam, Cantilever, Column };

struct Bar {
    float stiffness;
    int layers, slenderness;  ///< Particles along the edges of its square section; its length over them.
    Load load;

    double length() const { return slenderness * layers * double(SIZE); }
    double side() const { return layers * double(SIZE); }

    /// Closed form of how far it sags under a gravity of 1 m/s2 [m], by Timoshenko's theory (Cowper's coefficient of
    /// shear for a rectangle). Its section is what the particles fill as cubes; its length that between supports,
    /// beyond which a free end has half a particle more.
    double sagByGravity() const
    {
        const double area = side() * side(), inertia = area * area / 12.0, q = DENSITY * area, l = length();
        const double bending = stiffness * inertia;
        const double shear = 10.0 * (1.0 + POISSON) / (12.0 + 11.0 * POISSON) * stiffness / (2.0 * (1.0 + POISSON)) *
                             area;
        const double all = l + 0.5 * double(SIZE);
        switch (load) {
            case Load::Beam: return 5.0 * q * std::pow(l, 4) / (384.0 * bending) + q * l * l / (8.0 * shear);
            case Load::Cantilever:
                return q * l * l * (6.0 * all * all - 4.0 * all * l + l * l) / (24.0 * bending) +
                       q * (all * l - 0.5 * l * l) / shear;
            case Load::Column: return DENSITY / double(stiffness) * (all * l - 0.5 * l * l);
        }
        return 0.0;
    }
};

/// A bar along x, of a cantilever and a column its layer at the lower end pinned, of a beam its end layers on smooth
/// blocks.
World barWorld(const Bar& bar, double gravity)
{
    Settings settings;
    settings.gravity = float(gravity) * (bar.load == Load::Column ? Vector3f(1, 0, 0) : Vector3f(0, -1, 0));
    WorldBuilder builder(SIZE / 2, settings);
    Material material;
    material.density = static_cast<float>(DENSITY);
    material.elasticity.stiffness = bar.stiffness;
    material.elasticity.poissonRatio = static_cast<float>(POISSON);
    material.staticFriction = material.kineticFriction = 0.0f;
    builder.addMaterial(material);
    const std::vector<Vector3f> lattice = boxLattice({bar.slenderness * bar.layers + 1, bar.layers, bar.layers}, SIZE);
    std::vector<uint32_t> pins;
    const auto half = static_cast<float>(0.5 * bar.length());
    for (uint32_t i = 0; i < lattice.size(); ++i)
        if (bar.load != Load::Beam && lattice[i].x() < 0.5f * SIZE - half) pins.push_back(i);
    for (float side : {-1.0f, 1.0f}) {
        if (bar.load != Load::Beam) continue;
        Collider block = floorPlane(0.0f);
        block.shape = ColliderShape::Box;
        block.halfExtents = {4 * SIZE, 4 * SIZE, 8 * SIZE};
        // Only the outermost layer is above it.
        block.position = {side * (half + 3.75f * SIZE), static_cast<float>(-0.5 * bar.side()) - 4 * SIZE, 0};
        builder.addCollider(block);
    }
    builder.beginObject("bar");
    builder.addSoftBody("bar", lattice, 0, pins);
    builder.endObject();
    return builder.build();
}

/// How far the middle of a beam is below its supports, or the free end from where it was [m].
double sagNow(const Bar& bar, const World& world, const ParticleState& state)
{
    const double half = 0.5 * bar.length(), lowest = 0.5 * (double(SIZE) - bar.side());
    const Vector3f down = world.settings.gravity.normalized();
    double sum = 0.0, supports = 0.0;
    int count = 0, supported = 0;
    for (size_t i = 0; i < state.positions.size(); ++i) {
        const Vector3f& rest = world.particles[i].restPosition;
        const double moved = double((state.positions[i] - rest).dot(down));
        const double from = bar.load == Load::Beam ? std::abs(double(rest.x())) : half - double(rest.x());
        if (from < 0.6 * double(SIZE)) sum += moved, ++count;
        if (bar.load == Load::Beam && from > half - 0.5 * double(SIZE) && double(rest.y()) < lowest + 1e-4)
            supports += moved, ++supported;
    }
    return sum / count - (supported > 0 ? supports / supported : 0.0);
}

/// The sag over its closed form. A bar that is let go swings about it: the mean by Hann's window over five swings or
/// more is off by less than 1 % of their amplitude.
double sagOverClosedForm(const Bar& bar)
{
    const double byGravity = bar.sagByGravity(), gravity = std::min(SAG * bar.length() / byGravity, 9.81);
    const World world = barWorld(bar, gravity);
    Solver solver(gpu(), world);
    const double swing = 2.0 * std::numbers::pi *
                         std::sqrt(byGravity / 1.26);  // Rayleigh's, of a beam; others' are less
    const auto steps = std::max(int(std::ceil(5.0 * swing / double(world.settings.timeStep))), 60);
    double sum = 0.0, weights = 0.0;
    for (int k = 0; k < steps; ++k) {
        run(solver, world, double(world.settings.timeStep));
        const double weight = std::pow(std::sin(std::numbers::pi * (k + 0.5) / steps), 2);
        sum += weight * sagNow(bar, world, solver.readParticles());
        weights += weight;
    }
    return sum / weights / (gravity * byGravity);
}

/// From 20 kPa to 2 MPa at default settings. Asked: 10 %. The clusters of these bars by themselves, solved as one
/// linear system, differ from the closed form by -5 to 1 %, and the swing may add 1 %.
class SoftBars : public testing::TestWithParam<Bar> {};

TEST_P(SoftBars, SagAsTheClosedFormSays)
{
    EXPECT_NEAR(sagOverClosedForm(GetParam()), 1.0, 0.07);
}

std::vector<Bar> bars()
{
    std::vector<Bar> out;
    for (Load load : {Load::Beam, Load::Cantilever, Load::Column})
        for (const auto& [stiffness, layers, slenderness] :
             {std::tuple{2e4f, 3, 4}, {8e4f, 2, 8}, {8e4f, 3, 8}, {3e5f, 5, 4}, {2e6f, 3, 12}})
            out.push_back({stiffness, layers, slenderness, load});
    return out;
}

std::string nameOf(const testing::TestParamInfo<Bar>& info)
{
    const char* names[] = {"Beam", "Cantilever", "Column"};
    const Bar& bar = info.param;
    return names[static_cast<int>(bar.load)] + std::to_string(std::lround(bar.stiffness / 1e3f)) + "kPa" +
           std::to_string(bar.layers) + "Layers" + std::to_string(bar.slenderness);
}

INSTANTIATE_TEST_SUITE_P(All, SoftBars, testing::ValuesIn(bars()), nameOf);

}  // namespace

}  // namespace knuckle::test
