#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

// The highest speed that overlapping starts may reach [m/s]. A contact pushes a side that already leaves at 1 m/s
// (LEAVING_SPEED) by no more than a tenth of 0.25 m/s, so ten in a row reach 1.25 m/s. The rest is a margin for
// iterations that end before all contacts agree.
constexpr double TOP_SPEED = 2.0;
constexpr float EDGE = 3 * DIAMETER;

/// What happened in a world while its overlaps came apart.
struct Way {
    double topSpeed = 0.0;       ///< Of any particle at the end of any step [m/s].
    double ownSpeed = 0.0;       ///< The same for whole movers, sqrt(2 E/m), without the part from their own fall.
    double energyGained = 0.0;   ///< Kinetic and potential, from the start to the end [J].
    double kineticEnergy = 0.0;  ///< At the end [J].
    Measures measures;           ///< At the end.
};

/// Kinetic and potential energy of movers: bodies, then loose particles. A shared particle counts with its first body.
struct Mover {
    double mass = 0.0, kinetic = 0.0, potential = 0.0, highest = -INFINITY;
};

class Watch {
public:
    Watch(const World& world, double seconds) : world_(world), movers_(world.bodies.size() + world.particles.size())
    {
        Solver solver(gpu(), world);
        const double before = look(solver);
        const auto steps = static_cast<uint64_t>(std::lround(seconds / static_cast<double>(world.settings.timeStep)));
        double now = before;
        for (uint64_t i = 0; i < steps; ++i) {
            solver.step();
            solver.checkCounters(i);
            now = look(solver);
        }
        way.energyGained = now - before;
        way.measures = solver.measure();
    }

    Way way;

private:
    /// @returns all energy [J].
    double look(Solver& solver)
    {
        const ParticleState state = solver.readParticles();
        for (Mover& mover : movers_) mover = {.highest = mover.highest};
        for (size_t i = 0; i < world_.particles.size(); ++i) {
            const Particle& particle = world_.particles[i];
            const double mass = particle.mass, speed = state.velocities[i].norm();
            Mover& mover = movers_[particle.body != NO_INDEX ? particle.body : world_.bodies.size() + i];
            mover.mass += mass;
            mover.kinetic += 0.5 * mass * speed * speed;
            mover.potential += mass * GRAVITY * static_cast<double>(state.positions[i].y());
            way.topSpeed = std::max(way.topSpeed, speed);
        }
        double energy = 0.0;
        way.kineticEnergy = 0.0;
        for (Mover& mover : movers_) {
            if (mover.mass == 0.0) continue;
            energy += mover.kinetic + mover.potential;
            way.kineticEnergy += mover.kinetic;
            mover.highest = std::max(mover.highest, mover.potential / mover.mass);
            const double own = (mover.kinetic + mover.potential) / mover.mass - mover.highest;
            way.ownSpeed = std::max(way.ownSpeed, std::sqrt(2.0 * std::max(own, 0.0)));
        }
        return energy;
    }

    const World& world_;
    std::vector<Mover> movers_;
};

WorldBuilder onTheFloor()
{
    WorldBuilder builder = makeBuilder();
    builder.addCollider(floorPlane());
    return builder;
}

/// Ten cubes; `place(k)` is the k-th one's place.
World tenCubes(const Eigen::Vector3i& counts, const std::function<Vector3f(int)>& place)
{
    WorldBuilder builder = onTheFloor();
    for (int k = 0; k < 10; ++k) addBox(builder, counts, {place(k)});
    return builder.build();
}

/// Calls `add` for ten poses: each `half` [m] from the last in a random direction, with a random rotation.
World clump(uint32_t seed, float half, const std::function<void(WorldBuilder&, const Pose&)>& add)
{
    WorldBuilder builder = onTheFloor();
    std::mt19937 random(seed);
    const auto any = [&] { return static_cast<float>(random()) / 2147483648.0f - 1.0f; };
    Vector3f at(0, 0, 0);
    for (int k = 0; k < 10; ++k) {
        const float w = any(), x = any(), y = any(), z = any();
        add(builder, {at, Quaternionf(w, x, y, z).normalized()});
        const float dx = any(), dy = any(), dz = any();
        at += half * Vector3f(dx, dy, dz).normalized();
        at.y() = std::abs(at.y());
    }
    return builder.build();
}

void addCapsule(WorldBuilder& builder, float radius, float halfHeight, const Pose& pose)
{
    const std::vector<Vector3f> places = halfHeight > 0 ? capsuleLattice(radius, halfHeight, DIAMETER)
                                                        : sphereLattice(radius, DIAMETER);
    std::vector<SurfaceDistance> surface;
    for (const Vector3f& place : places) surface.push_back(capsuleSurface(place, radius, halfHeight));
    builder.beginObject("capsule");
    builder.addBody("capsule", places, 0, Motion::Dynamic, surface, {radius, halfHeight});
    builder.endObject(pose);
}

}  // namespace

TEST(Apart, ATowerOfTenCubesHalfInsideEachOtherGrowsAndStands)
{
    for (const int n : {2, 3}) {
        SCOPED_TRACE(std::to_string(n) + " particles wide");
        const float edge = static_cast<float>(n) * DIAMETER;
        const World world = tenCubes({n, n, n}, [&](int k) { return Vector3f(0, 0.5f * edge * float(k), 0); });
        // The top rises by 5 edges, at 1 m/s or a little less.
        const Way way = Watch(world, 3.0).way;
        EXPECT_LT(way.topSpeed, TOP_SPEED);
        EXPECT_LT(way.measures.worstPenetration, 0.1f * DIAMETER);  // measured 0.013
        // Cube k was at k/2 edges and is at k + 1/2. At most 1 % more than this needs, and little less: 3 % of
        // penetration at each of 4.5 contacts below the mean cube are 0.05 edges of 2.75, with a third of it to spare.
        double mass = 0.0;
        for (const Particle& particle : world.particles) mass += static_cast<double>(particle.mass);
        const double lift = mass * GRAVITY * static_cast<double>(edge) * (4.5 / 2 + 0.5);
        EXPECT_LT(way.energyGained, 1.01 * lift);
        EXPECT_GT(way.energyGained, 0.97 * lift);
        EXPECT_LT(way.kineticEnergy, 0.0025 * lift);  // measured 3.2e-4
    }
}

TEST(Apart, ACrookedTowerGrowsAndOnlyThenFalls)
{
    // Balls do not rest on balls a fifth of a diameter aside: the tower also falls when built without overlaps.
    const World world = tenCubes({3, 3, 3}, [](int k) {
        return Vector3f(0.02f * static_cast<float>(k % 3), 0.5f * EDGE * static_cast<float>(k), 0);
    });
    const Way way = Watch(world, 4.0).way;
    EXPECT_LT(way.ownSpeed, TOP_SPEED);
    EXPECT_LT(way.measures.worstPenetration, 0.01f * DIAMETER);  // measured 0.0013
}

TEST(Apart, RowsAndBlocksOfCubesHalfInsideEachOtherDoNotFly)
{
    const auto row = [](int k) { return Vector3f(0.5f * EDGE * static_cast<float>(k), 0, 0); };
    const auto layers = [](int k) { return Vector3f(0.5f * EDGE * Eigen::Vector3i(k % 5, k / 5, 0).cast<float>()); };
    const auto block = [](int k) {
        return Vector3f(0.5f * EDGE * Eigen::Vector3i(k % 2, k / 4, k / 2 % 2).cast<float>());
    };
    const auto onePlace = [](int) { return Vector3f(0, 0, 0); };
    const std::vector<std::pair<std::string, std::function<Vector3f(int)>>> places = {
        {"row", row}, {"layers", layers}, {"block", block}, {"one place", onePlace}};
    for (const auto& [name, place] : places) {
        SCOPED_TRACE(name);
        const World world = tenCubes({3, 3, 3}, place);
        const Way way = Watch(world, name == "one place" ? 6.0 : 4.0).way;
        EXPECT_LT(name == "one place" ? way.ownSpeed : way.topSpeed, TOP_SPEED);
        EXPECT_LT(way.measures.worstPenetration, 0.04f * DIAMETER);  // measured 0.0045
        EXPECT_LT(way.kineticEnergy, 0.6);                           // of 270 kg: at rest; measured 0.08
    }
}

TEST(Apart, TwoCubesInOnePlaceComeApart)
{
    WorldBuilder builder = onTheFloor();
    for (int k = 0; k < 2; ++k) addBox(builder, {3, 3, 3}, {Vector3f(0, 0.5f * EDGE, 0)});
    const World world = builder.build();
    // No more than a single contact recovers.
    const Way way = Watch(world, 3.0).way;
    EXPECT_LT(way.topSpeed, 0.5);
    EXPECT_LT(way.measures.worstPenetration, 0.012f * DIAMETER);  // measured 0.0015
    EXPECT_LT(way.kineticEnergy, 2e-4);                           // measured 2e-5
}

TEST(Apart, ClumpsOfTenGainNoSpeedButByFalling)
{
    const auto cube = [](WorldBuilder& builder, const Pose& pose) { addBox(builder, {3, 3, 3}, pose); };
    const auto ball = [](WorldBuilder& builder, const Pose& pose) { addCapsule(builder, 0.2f, 0, pose); };
    const auto capsule = [](WorldBuilder& builder, const Pose& pose) { addCapsule(builder, 0.12f, 0.16f, pose); };
    using Kind = std::pair<float, std::function<void(WorldBuilder&, const Pose&)>>;
    for (const uint32_t seed : {1u, 2u, 3u}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        for (const auto& [half, add] : {Kind{0.5f * EDGE, cube}, Kind{0.2f, ball}, Kind{0.2f, capsule}}) {
            const World world = clump(seed, half, add);
            const Way way = Watch(world, 3.0).way;
            EXPECT_LT(way.ownSpeed, TOP_SPEED);
            EXPECT_LT(way.measures.worstPenetration, 0.015f * DIAMETER);  // measured 0.0017
        }
    }
}

TEST(Apart, ATowerOfTenJointedPairsGrowsWithoutFlying)
{
    for (const JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal}) {
        SCOPED_TRACE(static_cast<int>(type));
        WorldBuilder builder = onTheFloor();
        for (int k = 0; k < 10; ++k) {
            PairSpec pair;
            pair.joint.type = type;
            addJointedPair(builder, pair, {Vector3f(0, 0.5f * EDGE * static_cast<float>(k), 0)});
        }
        const World world = builder.build();
        const Way way = Watch(world, 2.5).way;
        EXPECT_LT(way.topSpeed, TOP_SPEED);
        EXPECT_LT(way.measures.worstPenetration, 0.1f * DIAMETER);  // measured 0.0134
        EXPECT_LT(way.measures.worstJointGap, 2e-5f * DIAMETER);    // measured 2.4e-6
    }
}

TEST(Apart, GrainsHalfInsideEachOtherDoNotFly)
{
    WorldBuilder builder = onTheFloor();
    std::mt19937 random(5);
    const auto any = [&] { return static_cast<float>(random()) / 2147483648.0f - 1.0f; };
    for (int k = 0; k < 216; ++k) {
        Particle grain;
        grain.position = 0.5f * DIAMETER * Eigen::Vector3i(k % 6, k / 6 % 6, k / 36).cast<float>();
        for (float& x : grain.position) x += 0.02f * DIAMETER * any();
        builder.addLooseParticle(grain);
    }
    const World world = builder.build();
    const Way way = Watch(world, 2.0).way;
    EXPECT_LT(way.ownSpeed, 1.5 * TOP_SPEED);  // measured 2.2
    EXPECT_LT(way.measures.worstPenetration, 0.2f * DIAMETER);
}

}  // namespace knuckle::test
