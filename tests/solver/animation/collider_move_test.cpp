#include <cmath>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

BodyClip wild(uint32_t seed, float rate)
{
    Random random(seed);
    BodyClip clip{"wild", rate, 1};
    const Vector3f axis = random.direction(), to = random.inCube(2.0f);
    for (int k = 0; k <= 90; ++k) {
        const float t = static_cast<float>(k) / 30.0f;
        clip.roots.emplace_back(std::sin(t) * to + Vector3f(0.1f * t, 0, 0));
        clip.turns.emplace_back(Eigen::AngleAxisf(std::sin(2 * t), axis) *
                                Eigen::AngleAxisf(0.5f * t, Vector3f::UnitY()));
    }
    return clip;
}

/// Some moving colliders: one by itself, two together, and a static one between them.
World movingColliders()
{
    World world = mixedWorld();
    Random random(77);
    world.clips = {wild(1, 60), wild(2, 24)};
    for (int c = 0; c < 5; ++c) {
        Collider collider;
        collider.shape = c == 3 ? ColliderShape::Sphere : ColliderShape::Box;
        collider.position = random.inCube(1.0f);
        collider.orientation = random.rotation();
        world.colliders.push_back(collider);
    }
    const auto pose = [&] { return Pose{random.inCube(1.0f), random.rotation()}; };
    world.colliderMotions = {{1, {pose()}, pose(), {.clip = 0, .start = 0.2f, .speed = 1.3f}},
                             {3, {pose(), pose()}, pose(), {.clip = 1}}};
    world.colliders = collidersAt(world, 0.0);
    return world;
}

/// Runs `fixture`'s kernel once more after that many substeps. @returns the time at which it ends [s].
double moveAfter(KernelFixture& fixture, uint32_t substeps, const Defines& variant = {})
{
    gpu::Counters counters = fixture.counters();
    counters.substep = substeps;
    counters.due = 0;
    fixture.setCounters(counters);
    fixture.run("animation/collider_move", 3, variant);
    return (substeps + 1) * double{fixture.stages.parameters.substepTime};
}

/// Single precision over some 40 operations on places of 5 m.
constexpr float ROUNDING = 2e-5f;

}  // namespace

TEST(ColliderMove, CollidersAreWhereTheirClipsHaveThem)
{
    KernelFixture fixture(movingColliders());
    for (const uint32_t substeps : {0u, 7u, 100u, 901u, 5000u}) {
        const std::vector<Collider> wanted = collidersAt(fixture.world, moveAfter(fixture, substeps));
        const auto places = fixture.stages.colliders.colliderPlaces.download();
        for (size_t c = 0; c < wanted.size(); ++c) {
            EXPECT_LT((vec3(places[2 * c]) - wanted[c].position).norm(), ROUNDING) << substeps << ", collider " << c;
            EXPECT_LT(quaternion(places[2 * c + 1]).angularDistance(wanted[c].orientation), ROUNDING * 10)
                << substeps << ", collider " << c;
        }
    }
}

/// The previous place of a point is where the same point was before.
TEST(ColliderMove, TheMoveOfASubstepLeadsFromPlaceToPlace)
{
    KernelFixture fixture(movingColliders());
    moveAfter(fixture, 40);
    const auto before = fixture.stages.colliders.colliderPlaces.download();
    moveAfter(fixture, 41);
    const auto after = fixture.stages.colliders.colliderPlaces.download();
    const auto moves = fixture.stages.colliders.colliderMoves.download();
    const std::vector<bool> moving{false, true, false, true, true};
    for (size_t c = 0; c < moving.size(); ++c) {
        const Vector3f shift = vec3(after[2 * c]) - vec3(before[2 * c]);
        EXPECT_LT((vec3(moves[2 * c]) - shift).norm(), 1e-6f) << c;
        const Quaternionf turned = quaternion(moves[2 * c + 1]) * quaternion(before[2 * c + 1]);
        EXPECT_LT(turned.angularDistance(quaternion(after[2 * c + 1])), 1e-3f) << c;
        EXPECT_EQ(moves[2 * c].w > 0.0f, moving[c]) << c;
        const Collider& collider = fixture.world.colliders[c];
        const float reach = collider.shape == ColliderShape::Box ? collider.halfExtents.norm() : collider.radius;
        const float turn = 2.0f * quaternion(moves[2 * c + 1]).vec().norm();
        EXPECT_NEAR(moves[2 * c].w, shift.norm() + turn * reach, 1e-5f) << c;
    }
}

/// A search is due when the farthest point is further than the margin from its place in the last search.
TEST(ColliderMove, AsksForASearchWhenItHasComeTooFarSinceTheLast)
{
    constexpr float SPEED = 0.099f;
    World world = mixedWorld();
    // It moves 0.02 m, the margin, in 48.5 substeps of 1/240 s.
    world.clips = {{"slow", 1.0f, 1, {{0, 0, 0}, {1, 0, 0}}, {Quaternionf::Identity(), Quaternionf::Identity()}}};
    world.colliders.resize(1);
    world.colliderMotions = {{0, {Pose{}}, Pose{}, {.clip = 0, .speed = SPEED}}};
    KernelFixture fixture(std::move(world));
    const float way = SPEED * fixture.stages.parameters.substepTime;
    const auto margin = static_cast<uint32_t>(fixture.stages.parameters.drift / way);
    uint32_t searched = 0;
    for (uint32_t substep = 0; substep < 4 * margin; ++substep) {
        moveAfter(fixture, substep);
        gpu::Counters counters = fixture.counters();
        // Its place at the end of the substep against that at the end of the search's substep.
        const uint32_t since = searched == 0 ? substep + 1 : substep - searched;
        EXPECT_EQ(counters.due == 1, since > margin) << "substep " << substep;
        if (counters.due == 0) continue;
        ++counters.searchCount;
        searched = substep;
        fixture.setCounters(counters);
    }
    EXPECT_EQ(fixture.counters().searchCount, 3u);
}

/// Its clip samples a turn with some rounding between equal keys.
TEST(ColliderMove, WhatStandsStandsStill)
{
    World world = movingColliders();
    for (BodyClip& clip : world.clips) {
        std::ranges::fill(clip.roots, Vector3f(0.123f, 4.567f, -1.1f));
        std::ranges::fill(clip.turns, Quaternionf(0.3f, 0.5f, -0.7f, 0.1f).normalized());
    }
    world.colliders = collidersAt(world, 0.0);
    KernelFixture fixture(std::move(world));
    const auto places = fixture.stages.colliders.colliderPlaces.download();
    for (uint32_t substep = 0; substep < 50; ++substep) {
        moveAfter(fixture, substep);
        const auto now = fixture.stages.colliders.colliderPlaces.download();
        for (size_t k = 0; k < now.size(); ++k) {
            ASSERT_EQ(vec3(now[k]), vec3(places[k])) << substep;
        }
        const auto moves = fixture.stages.colliders.colliderMoves.download();
        for (size_t k = 0; k < moves.size(); k += 2) ASSERT_EQ(moves[k].w, 0.0f) << substep;
    }
}

}  // namespace knuckle::test
