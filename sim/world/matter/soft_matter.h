#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "sim/base/no_index.h"

namespace knuckle {

struct World;

/// How a soft body of a material answers to strain. Rigid bodies ignore it.
struct Elasticity {
    float stiffness = 5e4f;       ///< Young's modulus [Pa], > 0. A free column of height H sags by rho g H^2 / (2 E).
    float poissonRatio = 0.3f;    ///< Narrowing over stretching, 0 ... 0.45.
    float damping = 0.005f;       ///< Stress is E (strain + damping * strain rate) [s], 0 ... 1.
    float yield = 0.1f;           ///< Strain beyond which it flows, 0 ... 10; only where creep > 0.
    float creep = 0.0f;           ///< Rate at which it flows by the strain beyond yield [1/s], 0 ... 1000; 0: never.
    float maxDeformation = 0.5f;  ///< The most that it can flow, as a strain, 0 ... 2.
};

/// Particle::selfMargin of soft bodies [diameters]: particles within 2.5 diameters of each other at rest never touch,
/// so that only the elastic forces hold them apart.
inline constexpr float SOFT_SELF_MARGIN = 1.5f;

/// Particles without a rigid body that overlapping clusters hold together.
struct SoftBody {
    std::string name;
    uint32_t material = 0;
    uint32_t object = NO_INDEX;               ///< Index into World::objects.
    uint32_t assembly = NO_INDEX;             ///< Its own: particles that are near at rest never touch.
    Eigen::Quaternionf rotation{1, 0, 0, 0};  ///< How the rest pose is turned at the start (Eigen ctor is wxyz).
    uint32_t particleStart = 0, particleCount = 0;
    uint32_t clusterStart = 0, clusterCount = 0;
};

/// A block of World::clusterLinks: a piece of a soft body, matched to its shape at rest. A particle of k clusters
/// has m/k of its mass in each.
struct Cluster {
    uint32_t softBody = 0;
    uint32_t linkStart = 0, linkCount = 0;
};

/// Validates soft bodies.
void validateSoftBodies(const World& world);

}  // namespace knuckle
