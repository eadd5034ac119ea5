#include <algorithm>
#include <cmath>

#include "physics_test.h"
#include "sim/solver/measure.h"

namespace knuckle::test {

namespace {

Vector3f lattice(int x, int y, int z)
{
    return Eigen::Vector3i(x, y, z).cast<float>();
}

/// A tank with its floor at y = 0 and one corner at the origin, filled to `layers` particles.
struct Tank {
    Tank(int wide, int layers, int deep, std::vector<float> densities = {1000.0f})
    {
        for (float density : densities) {
            Material material;
            material.fluid = true;
            material.density = density;
            fluids.push_back(builder.addMaterial(material));
        }
        const float d = builder.fluidSpacing();
        width = d * static_cast<float>(wide);
        depth = d * static_cast<float>(deep);
        const Vector3f far(width, 0, depth);
        for (const auto& [place, normal] : {std::pair<Vector3f, Vector3f>{{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}},
                                            {far, {-1, 0, 0}}, {{0, 0, 0}, {0, 0, 1}}, {far, {0, 0, -1}}}) {
            Collider wall;
            wall.shape = ColliderShape::Plane;
            wall.position = place;
            wall.orientation = Quaternionf::FromTwoVectors(Vector3f::UnitY(), normal);
            builder.addCollider(wall);
        }
        const auto kinds = static_cast<int>(fluids.size());
        for (int k = 0; k < kinds; ++k) {
            std::vector<Vector3f> places;
            for (int y = layers * k / kinds; y < layers * (k + 1) / kinds; ++y)
                for (int z = 0; z < deep; ++z)
                    for (int x = 0; x < wide; ++x) places.push_back(d * (lattice(x, y, z) + Vector3f::Constant(0.5f)));
            builder.addFluid(places, {0, 0, 0}, fluids[k]);
        }
    }

    WorldBuilder builder = makeBuilder();
    std::vector<uint32_t> fluids;
    float width = 0, depth = 0;
};

double meanHeight(const World& world, const ParticleState& state, uint32_t material)
{
    double sum = 0.0;
    int count = 0;
    for (size_t i = 0; i < world.particles.size(); ++i)
        if (world.particles[i].material == material) {
            sum += state.positions[i].y();
            ++count;
        }
    return sum / count;
}

/// The share of a cube's volume that lies below `level`, from 8000 points of it.
double submerged(const BodyState& body, float edge, double level)
{
    int below = 0;
    for (int k = 0; k < 8000; ++k) {
        const Vector3f p = lattice(k % 20, k / 20 % 20, k / 400) / 20.0f - Vector3f::Constant(0.475f);
        below += (body.position + body.rotation * (edge * p)).y() < level;
    }
    return below / 8000.0;
}

TEST(Fluid, WaterAtRestKeepsItsDensityAndVolumeAndIsQuiet)
{
    Tank tank(13, 13, 11);
    const World world = tank.builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 3.0);
    const ParticleState state = solver.readParticles();
    // The mean height of what fills a tank to H is H/2; 13 layers of 0.05 m.
    EXPECT_NEAR(2.0 * meanHeight(world, state, tank.fluids[0]), 0.65, 0.02 * 0.65);
    EXPECT_LT(solver.measure().meanDensityError, 0.01f);
    double speeds = 0.0;
    for (const Vector3f& v : state.velocities) speeds += v.squaredNorm();
    // A particle's weight gives it gravity times a substep, 0.02 m/s, that the pressures take back.
    EXPECT_LT(std::sqrt(speeds / static_cast<double>(state.velocities.size())), 0.05);
}

TEST(Fluid, ABodyFloatsAsDeepAsItIsDense)
{
    for (float density : {300.0f, 600.0f}) {
        Tank tank(20, 11, 20);
        Material light;
        light.density = density;
        const uint32_t material = tank.builder.addMaterial(light);
        tank.builder.beginObject("cube");
        tank.builder.addBody("cube", boxLattice({4, 4, 4}, DIAMETER), material);
        const float edge = 4 * DIAMETER;
        tank.builder.endObject({Vector3f(0.5f * tank.width, 0.55f + 0.5f * edge - 0.8f * edge * density / 1000.0f,
                                         0.5f * tank.depth)});
        const World world = tank.builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 3.0);
        const double area = tank.width * tank.depth, water = world.fluidCount * std::pow(world.fluidSpacing, 3.0);
        const BodyState cube = solver.readBodies()[0];
        // The level rises by what the cube displaces.
        double level = water / area;
        for (int k = 0; k < 20; ++k) level = (water + submerged(cube, edge, level) * std::pow(edge, 3)) / area;
        EXPECT_NEAR(submerged(cube, edge, level), density / 1000.0, 0.05) << "density " << density;
    }
}

TEST(Fluid, TheLighterOfTwoRises)
{
    // The lighter begins below.
    Tank tank(9, 12, 9, {600.0f, 1000.0f});
    const World world = tank.builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 4.0);
    const ParticleState state = solver.readParticles();
    // Apart, their mean heights would differ by half of the 0.6 m; drops of either stay in the other for long.
    EXPECT_GT(meanHeight(world, state, tank.fluids[0]) - meanHeight(world, state, tank.fluids[1]), 0.15);
}

TEST(Fluid, KeepsItsMomentumWithABodyInIt)
{
    WorldBuilder builder = makeBuilder(weightless());
    Material water;
    water.fluid = true;
    const uint32_t material = builder.addMaterial(water);
    addBox(builder, {2, 2, 2}, {}, {0, 0, 1});
    std::vector<Vector3f> places;
    for (int k = 0; k < 11 * 11 * 11; ++k)
        places.push_back(builder.fluidSpacing() * (lattice(k % 11, k / 11 % 11, k / 121) - Vector3f::Constant(5.2f)));
    builder.addFluid(places, {0.5f, 0, 0}, material);
    const World world = builder.build();
    Solver solver(gpu(), world);
    const Totals before = totals(world, solver.readParticles());
    run(solver, world, 1.0);
    const Totals after = totals(world, solver.readParticles());
    // Pressures come in opposite pairs; what rounding leaves of some 500 substeps stays below 1e-4, as for bodies.
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-4 * before.speedSum);
}

}  // namespace

}  // namespace knuckle::test
