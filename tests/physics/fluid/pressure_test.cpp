#include <algorithm>
#include <cmath>

#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

constexpr float LENGTH = 0.8f, WIDTH = 0.5f, HINGE = 0.05f, STIFFNESS = 4000, DAMPING = 400;

/// Water before a gate, a plate of 1 x 8 x 5 particles that turns on a hinge near the floor against a spring.
World gated(int layers)
{
    WorldBuilder builder = makeBuilder();
    Material water, smooth;
    water.fluid = true;
    smooth.staticFriction = smooth.kineticFriction = 0;
    const uint32_t fluid = builder.addMaterial(water), plate = builder.addMaterial(smooth);
    for (const auto& [place, normal] : {std::pair<Vector3f, Vector3f>{{0, 0, 0}, {0, 1, 0}},
                                        {{0, 0, 0}, {1, 0, 0}},
                                        {{0, 0, 0}, {0, 0, 1}},
                                        {{0, 0, WIDTH}, {0, 0, -1}}})
        addPlane(builder, place, normal);
    const float s = builder.fluidSpacing();
    const int wide = static_cast<int>(std::lround(LENGTH / s)), deep = static_cast<int>(std::lround(WIDTH / s));
    std::vector<Vector3f> places;
    for (int k = 0; k < wide * deep * layers; ++k)
        places.push_back(s * (lattice(k % wide, k / wide / deep, k / wide % deep) + Vector3f::Constant(0.5f)));
    builder.addFluid(places, {0, 0, 0}, fluid);
    builder.beginObject("gate");
    builder.addBody("gate", boxLattice({1, 8, 5}, DIAMETER), plate);
    builder.endObject({Vector3f(LENGTH + 0.5f * DIAMETER, 4 * DIAMETER, 0.5f * WIDTH)});
    JointSpec hinge;
    hinge.type = JointType::Hinge;
    hinge.name = "hinge";
    hinge.anchor = {LENGTH + 0.5f * DIAMETER, HINGE, 0.5f * WIDTH};
    hinge.drive.stiffness = STIFFNESS;
    hinge.drive.damping = DAMPING;
    builder.joinPlaced(NO_INDEX, 0, hinge);
    return builder.build();
}

/// The level of the water [m]: its highest layer, half a rest distance above the particles.
double levelOf(const World& world, const ParticleState& state)
{
    std::vector<float> heights;
    for (size_t i = world.particles.size() - world.fluidCount; i < world.particles.size(); ++i)
        if (state.positions[i].x() < LENGTH - 0.2f) heights.push_back(state.positions[i].y());
    std::ranges::sort(heights);
    return heights[heights.size() * 97 / 100] + 0.5 * world.fluidSpacing;
}

}  // namespace

/// About a hinge at the height a, water of the depth h turns a gate by rho g w (h^3 / 6 - a h^2 / 2); the gate's weight
/// helps as it leans. The level is known to a tenth of a rest distance, 1 % of h, which is 3 % of the moment.
TEST(Pressure, TurnsAGateAsHydrostaticsSays)
{
    for (const int layers : {9, 12}) {
        const World world = gated(layers);
        Solver solver(gpu(), world);
        run(solver, world, 2.0);
        double angle = 0.0, level = 0.0;
        constexpr int LOOKS = 20;
        for (int k = 0; k < LOOKS; ++k) {
            run(solver, world, 0.05);
            const Vector3f up = solver.readBodies()[0].rotation * Vector3f::UnitY();
            angle += std::atan2(up.x(), up.y()) / LOOKS;
            level += levelOf(world, solver.readParticles()) / LOOKS;
        }
        const double weight = world.bodies[0].mass * GRAVITY * (4 * DIAMETER - HINGE) * std::sin(angle);
        const double truth = 1000 * GRAVITY * WIDTH * (std::pow(level, 3) / 6 - HINGE * level * level / 2);
        EXPECT_NEAR(STIFFNESS * angle - weight, truth, 0.03 * truth) << layers << " layers";
    }
}

}  // namespace knuckle::test
