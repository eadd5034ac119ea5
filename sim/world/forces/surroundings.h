#pragma once

#include <Eigen/Core>

namespace knuckle {

struct World;

/// What may change between two steps without another world.
struct Surroundings {
    Eigen::Vector3f gravity{0.0f, -9.81f, 0.0f};  ///< [m/s2]
    Eigen::Vector3f wind{0, 0, 0};                ///< The mean velocity of the air, where the world has it [m/s].
    float linearDamping = 0.0f;                   ///< [1/s], 0 ... 100.
    float maxSpeed = 100.0f;                      ///< [m/s], > 0.

    /// As a world begins.
    static Surroundings of(const World& world);
};

}  // namespace knuckle
