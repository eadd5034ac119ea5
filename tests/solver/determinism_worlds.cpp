#include "tests/solver/determinism_worlds.h"

#include <array>
#include <cmath>

#include "app/bench/bench_worlds.h"
#include "sim/rig/mesh/distance_grid.h"
#include "tests/pair_fixture.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr uint32_t PLAIN = 0, BOUNCY = 1;

WorldBuilder makeBuilder(const Settings& settings, bool bounces)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    builder.addMaterial({});
    Material rubber;
    rubber.restitution = bounces ? 0.7f : 0.0f;
    rubber.rollingFriction = 0.05f;
    builder.addMaterial(rubber);
    return builder;
}

void addBox(WorldBuilder& builder, const Pose& pose, uint32_t material = PLAIN, const Vector3f& velocity = {0, 0, 0},
            const Eigen::Vector3i& counts = {3, 3, 3})
{
    builder.beginObject("box");
    builder.addBody("box", boxLattice(counts, DIAMETER), material);
    builder.endObject(pose, velocity, {1, 2, 3});
}

/// Pairs in which one body spins against its limit, with a spring or rigid.
void addLimited(WorldBuilder& builder, const Vector3f& place)
{
    Random random(501);
    int k = 0;
    for (JointType type : {JointType::Ball, JointType::Hinge, JointType::Universal}) {
        for (const float stiffness : {5.0f, std::numeric_limits<float>::infinity()}) {
            PairSpec pair;
            pair.joint.type = type;
            if (type == JointType::Ball) {
                pair.joint.limits.swing = 0.3f;
                pair.joint.limits.twist = {-0.2f, 0.3f};
            } else {
                pair.joint.limits.bend = {-0.2f, 0.1f};
            }
            if (type == JointType::Universal) pair.joint.limits.secondBend = {-0.1f, 0.3f};
            pair.joint.limits.stiffness = stiffness;
            const Vector3f at = place + Vector3f(0.9f * static_cast<float>(k % 2), 0.4f * static_cast<float>(k / 2), 0);
            addJointedPair(builder, pair, {at, random.rotation()}, {0, -2, 0}, 5.0f * random.direction());
            ++k;
        }
    }
}

/// Chains that hang from a fixed link, one of which bears less than its weight.
void addTearing(WorldBuilder& builder, const Vector3f& place)
{
    for (int c = 0; c < 2; ++c) {
        builder.beginObject("chain");
        std::array<uint32_t, 4> links{};
        for (uint32_t b = 0; b < links.size(); ++b) {
            std::vector<Vector3f> places = boxLattice({3, 3, 3}, DIAMETER);
            for (Vector3f& p : places) p.y() -= 4 * DIAMETER * static_cast<float>(b);
            links[b] = builder.addBody("link", places, PLAIN, b == 0 ? Motion::Fixed : Motion::Dynamic);
            JointSpec joint;
            joint.anchor = {0, (2 - 4 * static_cast<float>(b)) * DIAMETER, 0};
            joint.along = {0, -1, 0};
            joint.axis = {1, 0, 0};
            joint.type = b == 2 ? JointType::Stiff : JointType::Ball;
            joint.strength.force = 1200.0f;  // three weigh 800 N, and swing
            if (b > 0) builder.addJoint(links[b - 1], links[b], joint);
        }
        const Quaternionf raised(Eigen::AngleAxisf(c == 0 ? 0.1f : 1.3f, Vector3f::UnitX()));
        builder.endObject({place + Vector3f(0.5f * static_cast<float>(c), 2, 0), raised});
    }
}

void addRounds(WorldBuilder& builder, const Vector3f& place, uint32_t material)
{
    Random random(502);
    for (int k = 0; k < 8; ++k) {
        const RoundShape round{0.15f + 0.02f * static_cast<float>(k % 3), k % 2 == 0 ? 0.0f : 0.12f};
        const auto places = k % 2 == 0 ? sphereLattice(round.radius, DIAMETER)
                                       : capsuleLattice(round.radius, round.halfHeight, DIAMETER);
        std::vector<SurfaceDistance> surface;
        for (const Vector3f& p : places) surface.push_back(capsuleSurface(p, round.radius, round.halfHeight));
        builder.beginObject("round");
        builder.addBody("round", places, material, Motion::Dynamic, surface, round);
        const Vector3f at(0.1f * random.between(-1, 1), 0.3f + 0.45f * static_cast<float>(k), 0.05f);
        builder.endObject({place + at, random.rotation()}, {0, -3, 0}, {2, 0, 1});
    }
}

/// Towers of three, and a box that comes down on the first of them when they sleep.
void addTowers(WorldBuilder& builder, const Vector3f& place)
{
    for (int k = 0; k < 9; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 3, 3}, DIAMETER), PLAIN);
        const Vector3f at(0.5f * static_cast<float>(k / 3), 0.15f + 0.3f * static_cast<float>(k % 3), 0);
        builder.endObject({place + at});
    }
    addBox(builder, {place + Vector3f(0, 4.2f, 0)});
}

ColliderGrid cubeGrid(float half)
{
    std::vector<Vector3f> vertices;
    for (int i = 0; i < 8; ++i) vertices.push_back(half * Vector3f(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    const std::vector<Triangle> triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                                             {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {2, 6, 7}, {2, 7, 3}};
    return makeDistanceGrid(vertices, triangles, DIAMETER);
}

/// Hills, a cube of mesh among them, and boxes and pairs that fall on both.
void addGrids(WorldBuilder& builder, const Vector3f& place)
{
    std::vector<float> heights;
    for (int z = 0; z < 6; ++z)
        for (int x = 0; x < 7; ++x) heights.push_back(0.2f * std::sin(2.0f * static_cast<float>(x + z)));
    Collider hills, cube;
    hills.shape = ColliderShape::Heightfield;
    hills.grid = builder.addColliderGrid(makeHeightfield({3, 2.5f}, 7, 6, heights));
    hills.position = place;
    cube.shape = ColliderShape::Mesh;
    cube.grid = builder.addColliderGrid(cubeGrid(0.3f));
    cube.position = place + Vector3f(0.3f, 0.3f, 0);
    cube.orientation = Quaternionf(Eigen::AngleAxisf(0.7f, Vector3f(1, 1, 0).normalized()));
    builder.addCollider(hills);
    builder.addCollider(cube);
    Random random(503);
    for (int k = 0; k < 8; ++k) {
        const Vector3f at = place +
                            Vector3f(0.15f * static_cast<float>(k) - 0.4f, 1.2f + 0.4f * static_cast<float>(k), 0);
        if (k % 3 == 0) addJointedPair(builder, {}, {at, random.rotation()}, {0, -3, 0});
        else addBox(builder, {at, random.rotation()}, k % 3 == 1 ? PLAIN : BOUNCY, {0, -3, 0});
    }
}

Collider boxAt(const Vector3f& place, const Vector3f& halfExtents)
{
    Collider box;
    box.shape = ColliderShape::Box;
    box.position = place;
    box.halfExtents = halfExtents;
    return box;
}

/// A second of a move and a turn about z [rad], then rest. @param waits keys before it starts. @returns the clip.
uint32_t addMoves(WorldBuilder& builder, const Vector3f& way, float turn, int waits = 0)
{
    BodyClip clip{"moves", 60.0f, 1};
    for (int k = -waits; k <= 60; ++k) {
        const float part = std::max(static_cast<float>(k) / 60.0f, 0.0f);
        clip.roots.emplace_back(part * way);
        clip.turns.emplace_back(Eigen::AngleAxisf(part * turn, Vector3f::UnitZ()));
    }
    return builder.addClip(std::move(clip));
}

}  // namespace

World limitedWorld()
{
    WorldBuilder builder = makeBuilder({}, false);
    builder.addCollider({});
    addLimited(builder, {0, 0.5f, 0});
    addTearing(builder, {-1.2f, 0, 0});
    return builder.build();
}

World bouncyWorld()
{
    WorldBuilder builder = makeBuilder({}, true);
    builder.addCollider({});
    Random random(504);
    for (int k = 0; k < 12; ++k) {
        const Vector3f at(0.1f * static_cast<float>(k % 3), 0.4f + 0.35f * static_cast<float>(k), 0);
        PairSpec pair;
        pair.materialOfA = BOUNCY;
        if (k % 4 == 3) addJointedPair(builder, pair, {at, random.rotation()}, {0, -4, 0});
        else addBox(builder, {at, random.rotation()}, BOUNCY, {0, -4, 0});
    }
    return builder.build();
}

World sleepyWorld(float freeze)
{
    Settings settings;
    if (freeze > 0.0f) settings.freeze = freeze;
    else settings.sleepSpeed = 0.05f;
    WorldBuilder builder = makeBuilder(settings, false);
    builder.addCollider({});
    addTowers(builder, {0, 0, 0});
    return builder.build();
}

World movingWorld()
{
    Settings settings;
    settings.sleepSpeed = 0.05f;
    WorldBuilder builder = makeBuilder(settings, true);
    builder.addCollider(planeAt({0, -0.4f, 0}, {0, 1, 0}));
    addTowers(builder, {-3.5f, -0.4f, 0});
    addGrids(builder, {0, 0, 0});
    addRounds(builder, {2.5f, 0.5f, 0}, BOUNCY);
    // The mesh turns, a lift is under the towers, and a piston beside them starts when they sleep.
    const uint32_t turning = addMoves(builder, Vector3f::Zero(), 2.0f * static_cast<float>(M_PI));
    builder.moveColliders(1, {builder.world().colliders.back().position}, {.clip = turning});
    builder.addCollider(boxAt({-3.0f, -0.5f, 0}, {0.3f, 0.1f, 0.3f}));
    builder.moveColliders(1, {{-3.0f, -0.5f, 0}}, {.clip = addMoves(builder, {0, 0.2f, 0}, 0.3f)});
    builder.addCollider(boxAt({-4.2f, 0, 0}, {0.2f, 0.4f, 0.4f}));
    builder.moveColliders(1, {{-4.2f, 0, 0}}, {.clip = addMoves(builder, {0.4f, 0, 0}, 0, 50)});
    Material fluid;
    fluid.fluid = true;
    std::vector<Vector3f> water = boxLattice({8, 8, 8}, builder.fluidSpacing());
    for (Vector3f& place : water) place += Vector3f(0.3f, 1.2f, 0.3f);
    builder.addFluid(water, {0, 0, 0}, builder.addMaterial(fluid));
    return builder.build();
}

World towerWorld()
{
    WorldBuilder builder = makeBuilder({}, false);
    builder.addCollider({});
    builder.beginObject("block");
    builder.addBody("block", boxLattice({5, 2, 5}, DIAMETER), PLAIN, Motion::Fixed);
    builder.endObject({Vector3f(0, 0.1f, 0)});
    for (int k = 0; k < 8; ++k) {
        builder.beginObject("cube");
        builder.addBody("cube", boxLattice({3, 3, 3}, DIAMETER), PLAIN);
        builder.endObject({Vector3f(0.01f * static_cast<float>(k % 2), 0.35f + 0.3f * static_cast<float>(k), 0)});
    }
    addBox(builder, {Vector3f(-2, 1.2f, 0.05f)}, PLAIN, {4, 1, 0});
    return builder.build();
}

World roundWorld()
{
    WorldBuilder builder = makeBuilder({}, false);
    builder.addCollider({});
    addRounds(builder, {0, 0, 0}, BOUNCY);
    addBox(builder, {Vector3f(0, 0.1f, 0)}, PLAIN, {0, 0, 0}, {6, 2, 6});
    return builder.build();
}

World gridWorld()
{
    WorldBuilder builder = makeBuilder({}, false);
    addGrids(builder, {0, 0, 0});
    return builder.build();
}

World everyWorld(GridKind grid)
{
    Settings settings;
    settings.grid = grid;
    settings.sleepSpeed = 0.05f;
    WorldBuilder builder = makeBuilder(settings, true);
    builder.addCollider(planeAt({0, -0.4f, 0}, {0, 1, 0}));
    addLimited(builder, {2.5f, 0.5f, 0});
    addTearing(builder, {4, 0, 0.1f});
    addRounds(builder, {-0.4f, 0.5f, 0.2f}, BOUNCY);
    addTowers(builder, {-3.5f, -0.4f, 0});
    addGrids(builder, {0, 0, 0});
    World world = builder.build();
    world.shown = {.ages = true, .contactForces = true};
    return world;
}

std::vector<Matter> matters()
{
    return {{"Pairs", [] { return table2World(40, {}); }},
            {"Paper", [] { return table2World(20, paperSettings()); }},
            {"Soft", softWorld},
            {"Ropes", ropeWorld},
            {"Fluids", fluidWorld},
            {"Emitters", emitterWorld},
            {"Bounces", bouncyWorld},
            {"Windy", windyWorld},
            {"Tower", towerWorld},
            {"Freeze", [] { return sleepyWorld(0.5f); }},
            {"Held", heldWorld},
            {"Animated", animatedWorld},
            {"Driven", drivenWorld},
            {"Moving", movingWorld},
            {"Mechanism", mechanismWorld},
            {"Everything", [] { return everyWorld(GridKind::Lattice); }}};
}

}  // namespace knuckle::test
