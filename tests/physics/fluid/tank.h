#pragma once

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// A tank with its floor at y = 0 and one corner at the origin, filled to `layers` particles; several fluids have equal
/// shares, the first one at the bottom.
struct Tank {
    Tank(int wide, int layers, int deep, const std::vector<float>& densities = {1000.0f},
         const Settings& settings = {});

    WorldBuilder builder;
    std::vector<uint32_t> fluids;
    float width = 0, depth = 0;
};

/// Adds the half space behind a plane through `place`.
void addPlane(WorldBuilder& builder, const Vector3f& place, const Vector3f& normal);
/// Adds the floor y = 0 and, facing the middle, walls at x = 0, `width` and z = 0, `depth` [m].
void addWalls(WorldBuilder& builder, float width, float depth);
Vector3f lattice(int x, int y, int z);
/// Of all particles, including those of bodies [m/s].
double rootMeanSquareSpeed(const ParticleState& state);
double meanHeight(const World& world, const ParticleState& state, uint32_t material);
/// The share of a box's volume below `level`, from 8000 points of it. @param size edges of the box [m].
double submerged(const BodyState& body, const Vector3f& size, double level);
/// The depth at which a box floats alone in a tank of that area: it raises the level by what it displaces.
double submergedIn(const World& world, const BodyState& body, const Vector3f& size, double area);

}  // namespace knuckle::test
