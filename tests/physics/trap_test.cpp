#include <cmath>
#include <functional>
#include <string>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

/// The depth of `point` in an axis-aligned cube about `centre`, above 0 inside [m].
float depthIn(const BodyState& body, const Vector3f& point, float halfEdge)
{
    const Vector3f p = body.rotation.conjugate() * (point - body.position);
    return halfEdge - p.cwiseAbs().maxCoeff();
}

/// Runs the world and returns the greatest speed of any particle on the way [m/s].
float topSpeed(Solver& solver, const World& world, double seconds)
{
    float top = 0.0f;
    for (double t = 0.0; t < seconds; t += 0.1) {
        run(solver, world, 0.1);
        top = std::max(top, solver.measure().maxSpeed);
    }
    return top;
}

/// Calls `add` for ten positions: in rows, `offset` from one to the next, the rows above each other and the first half
/// inside the floor.
World overlaps(const std::function<void(WorldBuilder&, const Vector3f&)>& add, const Vector3f& offset, int inRow)
{
    WorldBuilder builder = makeBuilder();
    builder.addCollider(floorPlane());
    for (int i = 0; i < 10; ++i) {
        const int row = i / inRow;
        const float up = 1.5f * DIAMETER * static_cast<float>(row);
        // Shifted a little, so that no two lattices coincide.
        add(builder, static_cast<float>(i % inRow) * offset + Vector3f(0.02f * static_cast<float>(i % 3), up, 0));
    }
    return builder.build();
}

void addCube(WorldBuilder& builder, const Vector3f& place)
{
    addBox(builder, {3, 3, 3}, {place});
}

}  // namespace

TEST(Trap, AGrainInABodysLatticeLeavesIt)
{
    for (const Vector3f& start : {Vector3f(0.05f, 0.05f, 0.05f), Vector3f(0.01f, 0.12f, -0.03f)}) {
        WorldBuilder builder = makeBuilder(weightless());
        addBox(builder, {5, 5, 5});
        Particle grain;
        grain.position = start;
        builder.addLooseParticle(grain);
        const World world = builder.build();
        Solver solver(gpu(), world);
        // Half a metre a second at most, over 0.25 m, and as long again for depths split over many contacts.
        run(solver, world, 2.0);
        const float depth = depthIn(solver.readBodies()[0], solver.readParticles().positions.back(), 0.25f);
        EXPECT_LT(depth, 0.0f) << "started at " << start.transpose();
    }
}

TEST(Trap, TwoBoxesThatStartInterleavedPart)
{
    for (const Vector3f& offset : {Vector3f(0.25f, 0.05f, 0.05f), Vector3f(0.05f, 0.15f, 0.02f)}) {
        WorldBuilder builder = makeBuilder(weightless());
        addBox(builder, {3, 3, 3});
        addBox(builder, {3, 3, 3}, {offset});
        const World world = builder.build();
        Solver solver(gpu(), world);
        const float top = topSpeed(solver, world, 2.0);
        EXPECT_LT(solver.measure().worstPenetration, 0.01f * DIAMETER) << offset.transpose();  // measured 0
        // A particle's distance from the other cube: none is inside any more.
        const auto bodies = solver.readBodies();
        const ParticleState state = solver.readParticles();
        for (size_t i = 0; i < state.positions.size(); ++i)
            EXPECT_LT(depthIn(bodies[i < 27 ? 1 : 0], state.positions[i], 0.15f), 0.5f * DIAMETER)
                << offset.transpose();
        EXPECT_LT(top, 1.0f) << offset.transpose();
    }
}

TEST(Trap, TenCubesHalfInsideEachOtherAndTheFloorComeApartWithoutFlying)
{
    // A row, and two rows on each other.
    for (const int inRow : {10, 5}) {
        SCOPED_TRACE("in a row: " + std::to_string(inRow));
        const World world = overlaps(addCube, {1.5f * DIAMETER, 0, 0.3f * DIAMETER}, inRow);
        Solver solver(gpu(), world);
        EXPECT_LT(topSpeed(solver, world, 4.0), 2.0f);
        EXPECT_LT(solver.measure().worstPenetration, 0.03f * DIAMETER);  // measured 0.0036
    }
}

TEST(Trap, TenJointedPairsHalfInsideEachOtherAndTheFloorComeApartWithoutFlying)
{
    const auto add = [](WorldBuilder& builder, const Vector3f& place) { addJointedPair(builder, {}, {place}); };
    const World world = overlaps(add, {0.3f * DIAMETER, 0, 1.5f * DIAMETER}, 10);
    Solver solver(gpu(), world);
    EXPECT_LT(topSpeed(solver, world, 4.0), 2.0f);
    EXPECT_LT(solver.measure().worstPenetration, 0.07f * DIAMETER);  // measured 0.0083
    EXPECT_LT(solver.measure().worstJointGap, 5e-6f * DIAMETER);     // measured 6e-7
}

}  // namespace knuckle::test
