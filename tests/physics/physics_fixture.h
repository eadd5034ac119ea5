#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "sim/solver/solver.h"
#include "sim/world/builder/builder.h"
#include "tests/pair_fixture.h"

namespace knuckle::test {

inline constexpr float DIAMETER = 0.1f;
inline constexpr double GRAVITY = 9.81;

/// The GL context of the whole test program: making one takes longer than most tests.
Gpu& gpu();

/// A builder with one material (density 1000 kg/m3, friction `friction`) at index 0.
WorldBuilder makeBuilder(const Settings& settings = {}, float friction = 0.5f);
/// Default settings without gravity.
Settings weightless();
/// A single box of `counts` particles as an object of its own. @returns its body's index.
uint32_t addBox(WorldBuilder& builder, const Eigen::Vector3i& counts, const Pose& pose = {},
                const Vector3f& velocity = {0, 0, 0}, const Vector3f& spin = {0, 0, 0});
/// Two 3x3x3 cubes 4 diameters apart along x with a joint between them. A is fixed if requested.
World jointedPair(JointType type, const Settings& settings, const Pose& pose = {}, const Vector3f& velocity = {0, 0, 0},
                  const Vector3f& spin = {0, 0, 0}, bool fixed = false, int limitSide = 0);
/// Opens an object of cubes in a row along x, joined, that do not touch each other, since a contact ends second order.
/// The caller may change them, and ends the object.
void beginRow(WorldBuilder& builder, uint32_t bodies, JointType type);
/// The particle that is at a place, the last of several. @returns NO_INDEX if there is none.
uint32_t particleAt(const WorldBuilder& builder, const Vector3f& place);
Collider floorPlane(float friction = 0.5f);

/// Runs `seconds`, checking the counters after each step.
void run(Solver& solver, const World& world, double seconds);

/// Sums over all particles, double precision, about the origin.
struct Totals {
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    Eigen::Vector3d angularMomentum = Eigen::Vector3d::Zero();
    double speedSum = 0.0;  ///< Sum of m |v|.
};
Totals totals(const World& world, const ParticleState& state);

/// Kinetic and gravitational energy of all particles [J].
double energyOf(const World& world, const ParticleState& state);

/// Of a body that swings about an axis along z: I / (m l), from its own links. @param hinge a point of the axis, in the
/// frame in which the body is built [m].
double reducedLength(const World& world, uint32_t body, const Vector3f& hinge);

/// Height of the lowest body's mass centre [m].
float lowestBody(const std::vector<BodyState>& bodies);

}  // namespace knuckle::test
