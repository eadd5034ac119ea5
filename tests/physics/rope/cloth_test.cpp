#include <cmath>

#include "sim/world/builder/parts/cloth.h"
#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float SIDE = 1.0f;

std::vector<uint32_t> upperCorners(const ClothSheet& sheet)
{
    std::vector<uint32_t> corners;
    for (uint32_t i = 0; i < sheet.nodes.size(); ++i)
        if (std::abs(sheet.nodes[i].x()) > 0.499f * SIDE && sheet.nodes[i].z() < -0.499f * SIDE) corners.push_back(i);
    EXPECT_EQ(corners.size(), 2u);
    return corners;
}

/// A sheet of a metre that begins upright and hangs by its upper corners.
World hangingCloth(const ClothSheet& sheet, const ClothSpec& spec, const Settings& settings = {})
{
    WorldBuilder builder = makeBuilder(settings);
    const Quaternionf upright(Eigen::AngleAxisf(0.5f * static_cast<float>(M_PI), Vector3f::UnitX()));
    addCloth(builder, "cloth", sheet, spec, upperCorners(sheet), {}, {Vector3f(0, 2, 0), upright});
    return builder.build();
}

/// The same sheet as triangles of a model.
ClothSheet triangleSheet(uint32_t cells, const ClothSpec& spec)
{
    std::vector<Vector3f> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
    for (uint32_t j = 0; j <= cells; ++j)
        for (uint32_t k = 0; k <= cells; ++k) {
            const auto n = static_cast<float>(cells), x = static_cast<float>(k), z = static_cast<float>(j);
            vertices.emplace_back((x / n - 0.5f) * SIDE, 0, (z / n - 0.5f) * SIDE);
            if (j == cells || k == cells) continue;
            const uint32_t corner = j * (cells + 1) + k, below = corner + cells + 1;
            triangles.push_back({corner, below, corner + 1});
            triangles.push_back({corner + 1, below, below + 1});
        }
    return meshSheet(vertices, triangles, DIAMETER, spec, 10000);
}

}  // namespace

TEST(Cloth, HangsByTwoCornersWithoutStretching)
{
    const ClothSpec spec;
    const World world = hangingCloth(gridSheet(SIDE, SIDE, DIAMETER, spec), spec);
    Solver solver(gpu(), world);
    float worst = 0.0f;
    for (int k = 0; k < 30; ++k) {
        run(solver, world, 0.1);
        worst = std::max(worst, solver.measure().worstStretch);
    }
    // Required: 1 %, also for the threads at the corners, which carry half of it each, 490 N.
    EXPECT_LT(worst, 0.01f);
    EXPECT_LT(solver.measure().maxSpeed, 0.5f);
}

TEST(Cloth, OfAModelWeighsItsAreaAndHangsWithoutStretching)
{
    const ClothSpec spec;
    Settings settings;
    settings.substeps = 8;  // each node is in three strands or more, instead of two in a grid
    const ClothSheet sheet = triangleSheet(7, spec);
    const World world = hangingCloth(sheet, spec, settings);
    double area = 0.0, loose = 0.0;
    for (float share : sheet.areas) area += static_cast<double>(share);
    for (const Particle& p : world.particles) loose += p.body == NO_INDEX ? static_cast<double>(p.mass) : 0.0;
    EXPECT_NEAR(area, SIDE * SIDE, 1e-7);  // a sum of single precision; measured 9e-9
    double held = 0.0;
    for (uint32_t i : upperCorners(sheet)) held += static_cast<double>(sheet.areas[i]);
    EXPECT_NEAR(loose, 1000.0 * DIAMETER * (SIDE * SIDE - held), 2e-5);  // measured 2.4e-6
    Solver solver(gpu(), world);
    run(solver, world, 3);
    EXPECT_LT(solver.measure().worstStretch, 0.01f);
    EXPECT_LT(solver.measure().maxSpeed, 0.5f);
}

TEST(Cloth, CarriesACubeAndLetsNothingThrough)
{
    WorldBuilder builder = makeBuilder();
    ClothSpec spec;
    const ClothSheet sheet = gridSheet(SIDE, SIDE, DIAMETER, spec);
    std::vector<uint32_t> held;
    for (uint32_t i : {0u, sheet.columns - 1}) {
        held.push_back(i);
        held.push_back(i + sheet.columns * (sheet.rows - 1));
    }
    addCloth(builder, "cloth", sheet, spec, held, {}, {Vector3f(0, 2, 0)});
    const uint32_t cube = addBox(builder, {3, 3, 3}, {Vector3f(0, 2.6f, 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 3);
    // It sags, but its threads from corner to corner are no longer than the cloth.
    EXPECT_GT(solver.readBodies()[cube].position.y(), 1.2f);
    EXPECT_LT(solver.measure().worstPenetration, 0.15f * DIAMETER);  // measured 0.017
    EXPECT_LT(solver.measure().meanStretch, 0.01f);
}

/// A cube of 22 kg that falls at 20 m/s on a sheet of 10 kg/m2 held by its edges.
World cubeIntoSheet()
{
    WorldBuilder builder(DIAMETER / 2);
    Material iron, canvas;
    iron.density = 815.0f;
    canvas.density = 100.0f;
    const uint32_t cube = builder.addMaterial(iron);
    ClothSpec spec;
    spec.material = builder.addMaterial(canvas);
    const ClothSheet sheet = gridSheet(2 * SIDE, 2 * SIDE, DIAMETER, spec);
    std::vector<uint32_t> edges;
    for (uint32_t i = 0; i < sheet.nodes.size(); ++i)
        if (sheet.nodes[i].cwiseAbs().maxCoeff() > 0.999f * SIDE) edges.push_back(i);
    addCloth(builder, "cloth", sheet, spec, edges, {}, {Vector3f(0, 1.5f, 0)});
    builder.beginObject("cube");
    builder.addBody("body", boxLattice({3, 3, 3}, DIAMETER), cube);
    builder.endObject({Vector3f(0.03f, 2.0f, 0.02f)}, Vector3f(0, -20, 0));
    return builder.build();
}

TEST(Cloth, StopsWhatComesFast)
{
    const World world = cubeIntoSheet();
    // 5 v t / d, v = sqrt(20^2 + 2 g 0.6) from its highest particles.
    EXPECT_EQ(world.settings.substeps, 17u);
    Solver solver(gpu(), world);
    run(solver, world, 0.15);
    // The sheet does not stretch: held at its edges it stops the cube at once. Without it, the cube would be 3 m lower.
    EXPECT_GT(solver.readBodies().back().position.y(), 1.5f - DIAMETER);
    EXPECT_LT(solver.measure().worstPenetration, 0.01f * DIAMETER);  // measured 0
}

}  // namespace knuckle::test
