#include "sim/solver/layout/soft_iterations.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/solver/layout/cluster_links.h"

namespace knuckle {

namespace {

constexpr uint32_t MOST_ITERATIONS = 32;

/// The largest growth of a cluster's pull on a particle with its displacement, per mass [1/s2].
double steepness(const Material& material, const ClusterMoments& moments)
{
    const Elasticity& e = material.elasticity;
    const double hardest = moments.mass * moments.inverse.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    const double flowed = e.creep > 0.0f ? 1.0 + double(e.maxDeformation) : 1.0;
    return double(e.stiffness / material.density) *
           std::max(hardest * flowed * flowed / (1.0 - 2.0 * double(e.poissonRatio)), moments.bending);
}

/// Of a soft body, h (h + damping) times its steepest pull.
double steepnessOfSubstep(const World& world, const SoftBody& soft)
{
    const double h = double(world.settings.timeStep) / world.settings.substeps;
    return h * (h + double(world.materials[soft.material].elasticity.damping)) * steepestPull(world, soft);
}

}  // namespace

double steepestPull(const World& world, const SoftBody& soft)
{
    std::vector<double> steep(soft.particleCount);  // per particle, weighted by the clusters' fractions of its mass
    for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c) {
        const Cluster& cluster = world.clusters[c];
        const double k = steepness(world.materials[soft.material], clusterMoments(world, cluster));
        for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
            const Link& link = world.clusterLinks[l];
            steep[link.particle - soft.particleStart] += k * double(link.mass / world.particles[link.particle].mass);
        }
    }
    return steep.empty() ? 0.0 : *std::max_element(steep.begin(), steep.end());
}

uint32_t softIterations(const World& world)
{
    double steepest = 0.0;
    for (const SoftBody& soft : world.softBodies) steepest = std::max(steepest, steepnessOfSubstep(world, soft));
    uint32_t n = world.settings.iterations;
    while (n < MOST_ITERATIONS && Chebyshev(n).followed() < steepest) ++n;
    return n;
}

float shownStiffness(const World& world, const SoftBody& soft)
{
    const double followed = Chebyshev(softIterations(world)).followed();
    const double share = followed / std::max(steepnessOfSubstep(world, soft), followed);
    return static_cast<float>(share) * world.materials[soft.material].elasticity.stiffness;
}

Chebyshev::Chebyshev(uint32_t n)
{
    constexpr double MOST_LEFT = 0.3;
    const double shift = std::cosh(std::acosh(1.0 / MOST_LEFT) / n);
    least = static_cast<float>((shift - 1.0) / (shift + 1.0));
    cosine = static_cast<float>(std::cos(std::numbers::pi / (2.0 * n)));
}

double Chebyshev::followed() const
{
    // The smallest root, as a share of the largest eigenvalue, is (1 + least - (1 - least) cosine) / 2.
    return 2.0 / (1.0 + double(least) - (1.0 - double(least)) * double(cosine)) - 1.0;
}

}  // namespace knuckle
