#include <cmath>
#include <numbers>

#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

/// Where the middle of water is along its tank after each step [m], in a tank of `wide` x `layers` x 4 rest distances,
/// after a push of 0.3 m/s.
std::vector<double> pathOf(int wide, int layers, double seconds)
{
    Tank tank(wide, layers, 4);
    World world = tank.builder.build();
    for (Particle& p : world.particles) p.velocity.x() = 0.3f;
    Solver solver(gpu(), world);
    std::vector<double> path;
    for (int k = 0; k < seconds / world.settings.timeStep; ++k) {
        run(solver, world, world.settings.timeStep);
        double middle = 0.0;
        const ParticleState state = solver.readParticles();
        for (const Vector3f& x : state.positions) middle += x.x() / static_cast<double>(state.positions.size());
        path.push_back(middle - 0.5 * tank.width);
    }
    return path;
}

struct Swing {
    double period, loss;  ///< Mean [s]; mean part of the amplitude that a period takes.
};

/// From the times of passages through the middle and the extremes between them.
Swing swingOf(const std::vector<double>& path, double timeStep)
{
    std::vector<double> passages, extremes;
    double farthest = 0.0;
    for (size_t k = 1; k < path.size(); ++k) {
        farthest = std::max(farthest, std::abs(path[k]));
        if (path[k - 1] * path[k] > 0.0 || path[k - 1] == 0.0) continue;
        const double part = path[k - 1] / (path[k - 1] - path[k]);
        passages.push_back((static_cast<double>(k) - 1.0 + part) * timeStep);
        extremes.push_back(farthest);
        farthest = 0.0;
    }
    const auto halves = static_cast<double>(passages.size() - 1);
    return {2.0 * (passages.back() - passages.front()) / halves,
            1.0 - std::pow(extremes.back() / extremes.front(), 2.0 / halves)};
}

/// Waves as long as the tank and its mirror image: w^2 = g k tanh(k depth), k = pi / length (Lamb 1932, section 228).
void expectSwing(int wide, int layers, double mostLoss)
{
    const double length = 0.05 * wide, depth = 0.05 * layers, k = std::numbers::pi / length;
    const double truth = 2.0 * std::numbers::pi / std::sqrt(GRAVITY * k * std::tanh(k * depth));
    const Swing swing = swingOf(pathOf(wide, layers, 2.6 * truth), 1.0 / 60.0);
    testing::Test::RecordProperty("loss" + std::to_string(layers), std::to_string(swing.loss));
    // Waves of a tenth of the depth are 1 % slower than the smallest (Stokes); 20 particles tell a length to half of
    // one.
    EXPECT_NEAR(swing.period, truth, 0.035 * truth) << layers << " layers";
    // No closed form: water itself loses less than 1 %.
    EXPECT_LT(swing.loss, mostLoss) << layers << " layers";
}

TEST(Slosh, SwingsAsLongAsWavesDoAndHardlyLosesHeight)
{
    expectSwing(20, 4, 0.16);
    expectSwing(20, 8, 0.1);
}

TEST(Slosh, OfFiftyParticlesLosesATwentiethAPeriod)
{
    expectSwing(50, 10, 0.05);
    expectSwing(50, 20, 0.055);
}

}  // namespace

/// Two legs of 6 x 5 rest distances, joined below a wall by a passage as wide, one filled higher: as a column of the
/// length L of their middle line, whose level swings with w^2 = 2 g / L (Bernoulli). The corners make L uncertain by
/// about a tenth of their width, 1.5 % of L.
TEST(Slosh, AUTubeSwingsAsItsLengthSays)
{
    constexpr int LEG = 6, WALL = 4, DEEP = 5, HIGH = 28, MORE = 3;
    WorldBuilder builder = makeBuilder();
    Material material;
    material.fluid = true;
    const uint32_t water = builder.addMaterial(material);
    const float s = builder.fluidSpacing(), leg = LEG * s;
    addWalls(builder, (2 * LEG + WALL) * s, DEEP * s);
    Collider wall;
    wall.shape = ColliderShape::Box;
    wall.halfExtents = {0.5f * WALL * s, 1, s * DEEP};
    wall.position = {leg + 0.5f * WALL * s, leg + 1, 0.5f * DEEP * s};
    builder.addCollider(wall);
    std::vector<Vector3f> places;
    for (int x = 0; x < 2 * LEG + WALL; ++x) {
        const int top = x < LEG ? HIGH + MORE : x < LEG + WALL ? LEG : HIGH - MORE;
        for (int y = 0; y < top; ++y)
            for (int z = 0; z < DEEP; ++z) places.push_back(s * (lattice(x, y, z) + Vector3f::Constant(0.5f)));
    }
    builder.addFluid(places, {0, 0, 0}, water);
    const World world = builder.build();
    Solver solver(gpu(), world);
    const double length = s * (2 * HIGH - LEG + LEG + WALL), half = std::numbers::pi * std::sqrt(length / 2 / GRAVITY);
    std::vector<double> difference;
    for (int k = 0; k < 4.6 * half / world.settings.timeStep; ++k) {
        run(solver, world, world.settings.timeStep);
        double sum = 0;
        for (const Vector3f& x : solver.readParticles().positions)
            sum += x.x() < leg ? 1 : x.x() > leg + WALL * s ? -1 : 0;
        difference.push_back(sum);
    }
    EXPECT_NEAR(swingOf(difference, world.settings.timeStep).period, 2 * half, 0.03 * 2 * half);
}

}  // namespace knuckle::test
