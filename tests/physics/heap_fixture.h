#pragma once

#include <functional>
#include <random>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// Fills a World with grains of one friction, on a floor of the same.
class GrainFill {
public:
    explicit GrainFill(float mu, const Settings& settings = {});
    void addGrain(const Vector3f& place);
    /// A lattice between two corners [diameters], shaken so that it holds nothing up, where `has` says so.
    void fill(const Vector3f& low, const Vector3f& high, float spacing,
              const std::function<bool(const Vector3f&)>& has = nullptr);
    /// A box between two corners [diameters].
    void addWall(const Vector3f& low, const Vector3f& high, float friction);
    /// A ball that is held until a time [s], of `density` [kg/m3]. @returns its body's index.
    uint32_t addBall(float radius, const Vector3f& place, float density, float until);
    World build() { return builder_.build(); }

private:
    WorldBuilder builder_;
    std::mt19937 random_{1};
};

/// Slope of a heap about the y axis that stands on `base` [degrees]: of the line fitted to the mean heights of the
/// highest grains in patches of 1 x 1.6 diameters, between a fifth and four fifths of its height. @param base [m].
double slopeOf(const std::vector<Vector3f>& grains, float base = 0.0f);

}  // namespace knuckle::test
