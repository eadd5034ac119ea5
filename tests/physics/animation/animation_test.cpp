#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr uint32_t BODIES = 4;

void addRow(WorldBuilder& builder)
{
    beginRow(builder, BODIES, JointType::Ball);
    builder.endObject();
}

/// Every body swings by itself; the first one moves on a curve and turns on the way. @param pace of all [rad/s].
BodyClip swinging(float pace, float seconds, float rate = 60.0f)
{
    BodyClip clip{"swinging", rate, BODIES};
    for (uint32_t k = 0; static_cast<float>(k) <= seconds * rate; ++k) {
        const float t = static_cast<float>(k) / rate;
        clip.roots.emplace_back(0.5f * std::sin(pace * t), 0.3f * std::cos(pace * t), t);
        for (uint32_t b = 0; b < BODIES; ++b) {
            const float place = static_cast<float>(b);
            const Vector3f axis = Vector3f(0.3f * place, 1.0f, 0.5f - place).normalized();
            clip.turns.emplace_back(
                Eigen::AngleAxisf(0.6f * std::sin(pace * t + place) + (b == 0 ? 0.4f * t : 0.0f), axis));
        }
    }
    return clip;
}

Animation rowAnimation(std::vector<ClipPlay> plays)
{
    Animation animation;
    animation.object = 0;
    animation.pose = {{1, 5, 2}, Quaternionf(Eigen::AngleAxisf(0.7f, Vector3f(1, 2, 3).normalized()))};
    animation.pivot = {0.1f, 0.2f, 0};
    animation.plays = std::move(plays);
    return animation;
}

/// @param h length of a step, which is one substep [s].
Settings singleSteps(float h)
{
    Settings settings = weightless();
    settings.timeStep = h;
    settings.substeps = 1;
    return settings;
}

/// A clip that keeps its shape and moves straight. @param way in `seconds` [m].
BodyClip straight(const Vector3f& way, float seconds)
{
    return {"straight", 1 / seconds, 1, {Vector3f::Zero(), way}, {Quaternionf::Identity(), Quaternionf::Identity()}};
}

/// A box that a clip moves for ever, with its middle at the pivot. @returns its object's index.
uint32_t addMoved(WorldBuilder& builder, const Eigen::Vector3i& counts, const Pose& pose, BodyClip clip,
                  bool loop = false)
{
    const uint32_t body = addBox(builder, counts, pose);
    Animation animation;
    animation.object = builder.world().bodies[body].object;
    animation.pose = pose;
    animation.plays = {{.clip = builder.addClip(std::move(clip)), .loop = loop}};
    builder.animate(animation);
    return body;
}

double momentumBefore(const World& world, const ParticleState& state, Eigen::Vector3d& sum)
{
    const Totals all = totals(world, state);
    sum = all.momentum;
    return all.speedSum;
}

}  // namespace

TEST(Animation, BodiesAreWhereTheirClipsHaveThem)
{
    WorldBuilder builder = makeBuilder();
    addRow(builder);
    const uint32_t a = builder.addClip(swinging(5.0f, 0.9f)), b = builder.addClip(swinging(3.0f, 2.0f, 24.0f));
    builder.animate(rowAnimation({{.clip = a, .start = 0.2f, .speed = 1.3f},
                                  {.clip = b, .at = 1.5f, .start = 0.5f, .fade = 0.3f, .loop = false},
                                  {.clip = a, .at = 2.5f, .fade = 0.2f, .inPlace = true}}));
    const World world = builder.build();
    Solver solver(gpu(), world);
    for (int i = 0; i <= 180; ++i) {
        const std::vector<Pose> wanted = bodyPlaces(world, world.animations[0], i * double{world.settings.timeStep});
        const std::vector<BodyState> bodies = solver.readBodies();
        for (uint32_t k = 0; k < BODIES; ++k) {
            // Single precision over some 40 operations on places of 10 m.
            ASSERT_LT((bodies[k].position - wanted[k].translation).norm(), 4e-5f) << "step " << i << " body " << k;
            ASSERT_LT(bodies[k].rotation.angularDistance(wanted[k].rotation), 4e-5f) << "step " << i << " body " << k;
        }
        ASSERT_LT(solver.measure().worstJointGap, 1e-5f) << "step " << i;
        run(solver, world, world.settings.timeStep);
    }
}

/// At ten moments of a clip: the momentum of the whole and of each body continues, and no joint opens.
TEST(Animation, WhatIsLetGoMovesOnAsItsClip)
{
    constexpr float H = 1.0f / 480;
    for (int moment = 1; moment <= 10; ++moment) {
        const float time = 0.17f * static_cast<float>(moment);
        WorldBuilder builder = makeBuilder(singleSteps(H));
        addRow(builder);
        builder.animate(rowAnimation({{.clip = builder.addClip(swinging(6.0f, 2.0f))}}));
        for (uint32_t b = 0; b < BODIES; ++b) builder.releaseBody(b, time);
        const World world = builder.build();
        Solver solver(gpu(), world);
        const int before = static_cast<int>(std::ceil(time / H - 1e-3));
        for (int i = 0; i < before; ++i) solver.step();
        Eigen::Vector3d momentum, after;
        const double scale = momentumBefore(world, solver.readParticles(), momentum);
        const std::vector<BodyState> told = solver.readBodies();
        solver.step();
        const std::vector<BodyState> free = solver.readBodies();
        // Joints change a body's speed by no more than its acceleration in the clip, up to 6^2 rad/s2 at an arm of a
        // metre, in a step: 36 H = 0.08 m/s of 3.
        for (uint32_t b = 0; b < BODIES; ++b)
            EXPECT_LT((free[b].velocity - told[b].velocity).norm(), 0.08f) << "at " << time << " body " << b;
        float gap = 0.0f;
        for (int i = 0; i < 80; ++i) {
            solver.step();
            gap = std::max(gap, solver.measure().worstJointGap / DIAMETER);
        }
        momentumBefore(world, solver.readParticles(), after);
        // BDF2's speed of a step is accurate to (6 H)^2 of the speeds, 2e-4.
        EXPECT_LT((after - momentum).norm(), 1e-3 * scale) << "at " << time;
        EXPECT_LT(gap, 0.01f) << "at " << time;
    }
}

/// Two boxes that meet: neither responds, so there is only the first search for contacts, until one is let go.
TEST(Animation, NothingIsSoughtUntilSomethingAnswers)
{
    WorldBuilder builder = makeBuilder(weightless());
    addMoved(builder, {3, 3, 3}, {}, straight({2, 0, 0}, 1), true);
    const uint32_t met = addMoved(builder, {3, 3, 3}, {{1.2f, 0, 0}}, straight({0, 0, 0}, 1), true);
    builder.releaseBody(met, 0.3f);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.25);
    EXPECT_EQ(solver.searchCount(), 1u);
    run(solver, world, 0.75);
    EXPECT_GT(solver.searchCount(), 1u);
    EXPECT_GT(solver.readBodies()[met].velocity.x(), 1.9f) << "pushed by what met it";
}

/// A piston of infinite mass gives a body (1 + e) times its own speed.
TEST(Animation, APistonGivesABlockTheSpeedOfTheClosedForm)
{
    for (const float e : {0.0f, 0.8f}) {
        WorldBuilder builder = makeBuilder(weightless());
        Material bouncing = builder.material(0);
        bouncing.restitution = e;
        const uint32_t material = builder.addMaterial(bouncing);
        addMoved(builder, {5, 5, 5}, {}, straight({2, 0, 0}, 1));
        builder.beginObject("block");
        builder.addBody("block", boxLattice({3, 3, 3}, DIAMETER), material);
        builder.endObject({{1.0f, 0, 0}});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 0.8);
        EXPECT_NEAR(solver.readBodies()[1].velocity.x(), 2 * (1 + e), 0.02 * 2 * (1 + e)) << "e " << e;
    }
}

/// A body on a turntable at r slides off if w^2 r is above mu g.
TEST(Animation, ATurntableCarriesABlockUpToTheSpeedOfFriction)
{
    constexpr float R = 2.5f, MU = 0.5f;  // particles push at their centres: R is known to half a diameter
    for (const float part : {0.97f, 1.03f}) {
        const float w = part * std::sqrt(MU * static_cast<float>(GRAVITY) / R);
        WorldBuilder builder = makeBuilder({}, MU);
        BodyClip turning{"turning", 24.0f * w / (2 * static_cast<float>(M_PI)), 1};
        for (float k = 0; k <= 24; ++k) {
            turning.roots.push_back(Vector3f::Zero());
            turning.turns.emplace_back(Eigen::AngleAxisf(static_cast<float>(M_PI) / 12 * k, Vector3f::UnitY()));
        }
        addMoved(builder, {61, 1, 61}, {}, std::move(turning), true);
        // Starts at the speed of the table.
        addBox(builder, {2, 2, 2}, {{R, 1.5f * DIAMETER, 0}}, {0, 0, -w * R}, {0, w, 0});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 3.0);
        const Vector3f block = solver.readBodies()[1].position;
        const float away = std::hypot(block.x(), block.z()) - R;
        if (part < 1) {
            EXPECT_LT(std::abs(away), DIAMETER);
        } else {
            EXPECT_GT(away, 5 * DIAMETER);
        }
    }
}

}  // namespace knuckle::test
