#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float PITCH = 0.4f;

/// Adds cubes in a net of `columns` x `rows`, joined to their neighbours by balls, as one object. @returns the bodies,
/// row by row.
std::vector<uint32_t> addNet(WorldBuilder& builder, int columns, int rows, const Pose& pose,
                             const Vector3f& spin = {0, 0, 0})
{
    const auto placeOf = [&](int column, int row) {
        return Vector3f(PITCH * (static_cast<float>(column) - 0.5f * static_cast<float>(columns - 1)), 0,
                        PITCH * (static_cast<float>(row) - 0.5f * static_cast<float>(rows - 1)));
    };
    builder.beginObject("net");
    std::vector<uint32_t> bodies;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            std::vector<Vector3f> places = boxLattice({2, 2, 2}, DIAMETER);
            for (Vector3f& place : places) place += placeOf(column, row);
            bodies.push_back(builder.addBody("cube", places, 0));
        }
    const auto join = [&](int column, int row, int nextColumn, int nextRow) {
        JointSpec spec;
        spec.name = "knot";
        spec.axis = Vector3f::UnitY();
        spec.anchor = 0.5f * (placeOf(column, row) + placeOf(nextColumn, nextRow));
        spec.along = placeOf(nextColumn, nextRow) - placeOf(column, row);
        builder.addJoint(bodies[static_cast<size_t>(row * columns + column)],
                         bodies[static_cast<size_t>(nextRow * columns + nextColumn)], spec);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (column + 1 < columns) join(column, row, column + 1, row);
            if (row + 1 < rows) join(column, row, column, row + 1);
        }
    builder.endObject(pose, Vector3f::Zero(), spin);
    return bodies;
}

}  // namespace

/// 108 cubes, 88 loops: more than a pass of the software driver goes through. Turning at 1 rad/s pulls at the knots.
/// In free fall all fall alike; the places of particles are floats of 5 m, and a substep adds rounding of 2.4e-7 m.
TEST(Net, OfManyLoopsFallsAsOne)
{
    WorldBuilder builder = makeBuilder();
    addNet(builder, 9, 12, {{0, 5, 0}, Quaternionf::Identity()}, {0, 1, 0});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.25);
    const Measures measures = solver.measure();
    EXPECT_LT(measures.worstJointGap, 0.01f * DIAMETER);
    const double fallen = 0.5 * GRAVITY * 0.25 * 0.25;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const BodyState& body : solver.readBodies()) centre += body.position.cast<double>();
    centre /= static_cast<double>(world.bodies.size());
    // Velocities are those of the middle of a substep, so all is half a substep late.
    const double late = 0.5 * GRAVITY * world.settings.timeStep / world.settings.substeps;
    EXPECT_NEAR(centre.y(), 5.0 - fallen, 0.25 * late + 1e-4);
    EXPECT_NEAR(centre.x(), 0.0, 1e-3);
    double mass = 0.0;
    for (const Particle& particle : world.particles) mass += particle.mass;
    EXPECT_NEAR(totals(world, solver.readParticles()).momentum.y() / mass, -GRAVITY * 0.25, late + 1e-3);
}

/// Each cube of the first row hangs on a ball of its own above it. In its plane such a net is as stiff as a truss, and
/// all of its loops have to agree. LOOP_ERROR lets each be wrong by 2e-7 m in an iteration; what stays of that does not
/// add up, since the next starts from where it is: 1e-5 m leaves room for the sag of 30 joints in a row.
TEST(Net, HangsStill)
{
    for (const auto& [columns, rows] : {std::pair{2, 3}, std::pair{3, 3}, std::pair{5, 6}}) {
        WorldBuilder builder = makeBuilder();
        const Quaternionf upright(Eigen::AngleAxisf(static_cast<float>(M_PI / 2), Vector3f::UnitX()));
        const std::vector<uint32_t> bodies = addNet(builder, columns, rows, {{0, 2, 0}, upright});
        for (int column = 0; column < columns; ++column) {
            JointSpec spec;
            spec.name = "pin";
            const float across = static_cast<float>(column) - 0.5f * static_cast<float>(columns - 1);
            spec.anchor = {PITCH * across, 2.0f + PITCH * 0.5f * static_cast<float>(rows), 0};
            builder.joinPlaced(NO_INDEX, bodies[static_cast<size_t>(column)], spec);
        }
        const World world = builder.build();
        Solver solver(gpu(), world);
        const std::vector<BodyState> start = solver.readBodies();
        for (int k = 0; k < 60; ++k) {
            run(solver, world, world.settings.timeStep);
            const std::vector<BodyState> now = solver.readBodies();
            for (size_t b = 0; b < now.size(); ++b)
                ASSERT_LT((now[b].position - start[b].position).norm(), 1e-5f)
                    << columns << " x " << rows << ", body " << b << " after " << k + 1 << " steps";
        }
    }
}

}  // namespace knuckle::test
