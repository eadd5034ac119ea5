#include <functional>
#include <limits>

#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

constexpr float INFINITE = std::numeric_limits<float>::infinity();

/// The error of validate() for a good world (two cubes with a ball, one collider) that `spoil` has changed.
/// @tparam Error the expected type; any other ends the test.
template <typename Error = std::logic_error>
std::string complaint(const std::function<void(World&)>& spoil)
{
    World world = jointedCubes({});
    world.colliders.emplace_back();
    spoil(world);
    std::string message = messageOf<Error>([&] { validate(world); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line";
    return message;
}

template <typename Error = std::logic_error>
std::string settingsComplaint(const std::function<void(Settings&)>& spoil)
{
    return complaint<Error>([&](World& world) { spoil(world.settings); });
}

}  // namespace

TEST(Validate, AGoodWorldPasses)
{
    EXPECT_EQ(complaint([](World&) {}), "");
    EXPECT_EQ(complaint([](World& w) {
                  w.settings = paperSettings();
                  w.settings.substeps = 4;
              }),
              "");
}

TEST(Validate, TheWorldNeedsARadiusAndParticles)
{
    EXPECT_EQ(complaint([](World& w) { w.particleRadius = 0.0f; }), "particle radius 0 m: must be above 0");
    EXPECT_EQ(complaint([](World& w) { w.particleRadius = NAN; }), "particle radius nan m: must be above 0");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.particles.clear(); }),
              "the world has no particles: add an object");
}

TEST(Validate, EverySettingHasItsRange)
{
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.timeStep = 0.0f; }), "solver time step 0 s: must be 0.0001 to 0.1");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.timeStep = NAN; }),
              "solver time step nan s: must be 0.0001 to 0.1");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.substeps = 65; }), "solver substeps 65: must be 1 to 64");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.substeps = 0; }), "solver substeps 0: must be 1 to 64");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.iterations = 0; }), "solver iterations 0: must be 1 to 64");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.iterations = 65; }), "solver iterations 65: must be 1 to 64");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.stabilization = 17; }), "solver stabilization 17: must be 0 to 16");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.contactMargin = 0.0f; }),
              "solver contact margin 0: must be 0.05 to 1");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.freeze = -1.0f; }), "solver freeze -1: must be 0 to 0.8 radii");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.virtualParticles = 2.0f; }),
              "solver virtual particles 2: must be 0 to 1");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.linearDamping = 101.0f; }),
              "solver damping 101 1/s: must be 0 to 100");
    EXPECT_EQ(settingsComplaint<InputError>([](Settings& s) { s.maxSpeed = 0.0f; }),
              "solver maximum speed 0 m/s: must be above 0");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.massScaling = -1.0f; }),
              "solver mass scaling -1 1/m: must be 0 to 10");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.sleepSpeed = NAN; }),
              "solver sleep speed nan m/s: must be 0 to 10");
    EXPECT_EQ(settingsComplaint([](Settings& s) { s.gravity.y() = INFINITE; }), "gravity must be finite");
}

TEST(Validate, WhatOneSolverHasNotIsRefused)
{
    EXPECT_EQ(settingsComplaint<InputError>([](Settings& s) { s.freeze = s.sleepSpeed = 0.1f; }),
              "solver: freeze and sleep do the same; set one of them to 0");
    EXPECT_EQ(settingsComplaint<InputError>([](Settings& s) {
                  s.solver = SolverKind::Paper;
                  s.sleepSpeed = 0.1f;
              }),
              "the paper's solver has no sleep; use solver freeze, or method impulse");
    EXPECT_EQ(settingsComplaint<InputError>([](Settings& s) { s.reduction = ReductionKind::Steps; }),
              "solver reduction is the paper's solver's; use reduction auto, or method paper");
    EXPECT_EQ(settingsComplaint<InputError>([](Settings& s) { s.stabilization = 1; }),
              "solver stabilization is the paper's solver's; use 0, or method paper");
    EXPECT_EQ(complaint<InputError>([](World& w) {
                  w.settings.solver = SolverKind::Paper;
                  w.materials[0].restitution = 0.5f;
              }),
              "material \"clay\": the paper's solver has no restitution; use 0, or solver method impulse");
    EXPECT_EQ(complaint<InputError>([](World& w) {
                  w.settings.solver = SolverKind::Paper;
                  w.materials[0].rollingFriction = 0.5f;
              }),
              "material \"clay\": the paper's solver has no rolling friction; use 0, or solver method impulse");
}

TEST(Validate, MaterialsNeedADensityAndKineticFrictionBelowStatic)
{
    EXPECT_EQ(complaint<InputError>([](World& w) { w.materials[0].density = 0.0f; }),
              "material \"clay\": density 0 kg/m3 must be above 0");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.materials[0].density = INFINITE; }),
              "material \"clay\": density inf kg/m3 must be above 0");
    EXPECT_EQ(complaint([](World& w) { w.materials[0].restitution = 1.5f; }),
              "material \"clay\": restitution 1.5 must be 0 to 1");
    EXPECT_EQ(complaint([](World& w) { w.materials[0].rollingFriction = -0.5f; }),
              "material \"clay\": rolling friction -0.5 must be 0 to 1");
    EXPECT_EQ(complaint([](World& w) { w.materials[0].kineticFriction = 0.75f; }),
              "material \"clay\": kinetic friction 0.75 must be 0 to its static friction 0.5");
    EXPECT_EQ(complaint([](World& w) { w.materials[0].kineticFriction = -0.5f; }),
              "material \"clay\": kinetic friction -0.5 must be 0 to its static friction 0.5");
}

TEST(Validate, ParticlesAreFiniteHeavyAndPointAtThingsThatExist)
{
    EXPECT_EQ(complaint([](World& w) { w.particles[5].position.x() = NAN; }),
              "particle 5: position or velocity is not finite");
    EXPECT_EQ(complaint([](World& w) { w.particles[5].velocity.z() = INFINITE; }),
              "particle 5: position or velocity is not finite");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.particles[6].mass = 0.0f; }),
              "particle 6: mass 0 kg must be above 0");
    EXPECT_EQ(complaint([](World& w) { w.particles[7].material = 3; }), "particle 7: there is no material 3");
    EXPECT_EQ(complaint([](World& w) { w.particles[8].body = 2; }), "particle 8: there is no body 2");
}

TEST(Validate, LinksAreBlocksThatAgreeWithBodiesAndParticles)
{
    EXPECT_EQ(complaint([](World& w) { w.bodies[1].linkStart = 3; }), "body \"b\": its links are not one block");
    EXPECT_EQ(complaint([](World& w) { w.bodies[0].linkCount = 0; }), "body \"a\": its links are not one block");
    EXPECT_EQ(complaint([](World& w) { w.bodies[1].linkCount = 500; }), "body \"b\": its links reach beyond the array");
    EXPECT_EQ(complaint([](World& w) { w.bodies[0].rotation.coeffs() *= 2.0f; }),
              "body \"a\": its rotation is not a unit quaternion");
    EXPECT_EQ(complaint([](World& w) { w.bodies[0].rotation.x() = NAN; }),
              "body \"a\": its rotation is not a unit quaternion");
    EXPECT_EQ(complaint([](World& w) { w.links[4].body = 1; }), "link 4: body or particle is wrong");
    EXPECT_EQ(complaint([](World& w) { w.links[4].particle = 999; }), "link 4: body or particle is wrong");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.links[4].mass = 0.0f; }), "link 4: mass 0 kg must be above 0");
    EXPECT_EQ(complaint([](World& w) { w.links.push_back(w.links.back()); }), "there are links of no body");
    EXPECT_EQ(complaint([](World& w) { w.particles[0].bodyCount = 2; }),
              "particle 0: 1 links name it, but it counts 2 bodies");
}

TEST(Validate, CollidersHaveAPlaceASizeAndFriction)
{
    EXPECT_EQ(complaint([](World& w) { w.colliders[0].position.y() = NAN; }),
              "collider 0: position or orientation is not finite");
    EXPECT_EQ(complaint([](World& w) { w.colliders[0].orientation.w() = 0.0f; }),
              "collider 0: position or orientation is not finite");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.colliders[0].radius = 0.0f; }),
              "collider 0: sizes must be above 0");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.colliders[0].halfExtents.z() = -1.0f; }),
              "collider 0: sizes must be above 0");
    EXPECT_EQ(complaint<InputError>([](World& w) { w.colliders[0].halfHeight = -1.0f; }),
              "collider 0: sizes must be above 0");
    EXPECT_EQ(complaint([](World& w) { w.colliders[0].kineticFriction = 0.75f; }),
              "collider 0: kinetic friction 0.75 must be 0 to its static friction 0.5");
}

}  // namespace knuckle::test
