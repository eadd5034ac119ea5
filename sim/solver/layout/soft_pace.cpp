#include "sim/solver/layout/soft_pace.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/solver/layout/cluster_links.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The pull of a soft body's clusters on its particles, for small displacements.
class PullAtRest {
public:
    PullAtRest(const World& world, const SoftBody& soft) : world_(world), soft_(soft)
    {
        const Elasticity& e = world.materials[soft.material].elasticity;
        const double nu = e.poissonRatio;
        ratio_ = double(e.stiffness) / double(world.materials[soft.material].density);
        shear_ = ratio_ / (1.0 + nu);
        dilation_ = shear_ * nu / (1.0 - 2.0 * nu);
        for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c)
            moments_.push_back(clusterMoments(world, world.clusters[c]));
    }

    /// @returns accelerations, towards the displacements. Pinned particles have none.
    std::vector<Vector3d> of(const std::vector<Vector3d>& displacements) const
    {
        std::vector<Vector3d> out(displacements.size(), Vector3d::Zero());
        for (uint32_t c = 0; c < soft_.clusterCount; ++c) addCluster(c, displacements, out);
        for (uint32_t i = 0; i < out.size(); ++i)
            if (world_.particles[soft_.particleStart + i].pinned) out[i].setZero();
        return out;
    }

private:
    void addCluster(uint32_t c, const std::vector<Vector3d>& displacements, std::vector<Vector3d>& out) const
    {
        const Cluster& cluster = world_.clusters[soft_.clusterStart + c];
        const ClusterMoments& m = moments_[c];
        const std::span links = std::span(world_.clusterLinks).subspan(cluster.linkStart, cluster.linkCount);
        Vector3d centre = Vector3d::Zero();
        Matrix3d map = Matrix3d::Zero();
        for (const Link& link : links) {
            const Vector3d moved = double(link.mass) * displacements[link.particle - soft_.particleStart];
            centre += moved / m.mass;
            map += moved * link.restOffset.cast<double>().transpose();
        }
        map = map * m.inverse;
        const Matrix3d strain = 0.5 * (map + map.transpose());
        const Matrix3d stress = shear_ * strain + dilation_ * strain.trace() * Matrix3d::Identity();
        const Matrix3d pull = m.mass * stress * m.inverse - ratio_ * m.bending * map;
        for (const Link& link : links) {
            const uint32_t i = link.particle - soft_.particleStart;
            const double share = double(link.mass) / double(world_.particles[link.particle].mass);
            out[i] += share *
                      (pull * link.restOffset.cast<double>() + ratio_ * m.bending * (displacements[i] - centre));
        }
    }

    const World& world_;
    const SoftBody& soft_;
    double ratio_ = 0.0, shear_ = 0.0, dilation_ = 0.0;  // Young's modulus and Lame's two, over the density
    std::vector<ClusterMoments> moments_;
};

double sizeOf(const std::vector<Vector3d>& values)
{
    double sum = 0.0;
    for (const Vector3d& x : values) sum += x.squaredNorm();
    return std::sqrt(sum);
}

/// The largest eigenvalue of the pull, by von Mises' iteration from noise.
double steepestPull(const World& world, const SoftBody& soft)
{
    constexpr int ROUNDS = 10;
    constexpr double MARGIN = 1.1;  // ten rounds find 0.97 of it (jelly's bodies)
    const PullAtRest pull(world, soft);
    std::vector<Vector3d> x(soft.particleCount);
    uint32_t noise = 1;
    for (Vector3d& value : x)
        for (double& component : value) {
            noise = noise * 1664525u + 1013904223u;
            component = double(noise >> 8) / double(1u << 23) - 1.0;
        }
    double found = 0.0;
    for (int k = 0; k < ROUNDS; ++k) {
        const double size = sizeOf(x);
        if (size == 0.0) return 0.0;
        for (Vector3d& value : x) value /= size;
        x = pull.of(x);
        found = sizeOf(x);
    }
    const Elasticity& e = world.materials[soft.material].elasticity;
    const double flowed = e.creep > 0.0f ? 1.0 + double(e.maxDeformation) : 1.0;
    return MARGIN * found * flowed * flowed;
}

}  // namespace

SoftPace softPace(const World& world, const SoftBody& soft)
{
    const Elasticity& e = world.materials[soft.material].elasticity;
    const double h = double(world.settings.timeStep) / world.settings.substeps, asked = double(e.damping);
    const double steepest = steepestPull(world, soft);
    SoftPace out;
    out.iterations = world.settings.iterations;
    double followed = Chebyshev(out.iterations).followed();
    while (followed < h * (h + asked) * steepest && out.iterations < MOST_SOFT_ITERATIONS)
        followed = Chebyshev(++out.iterations).followed();
    const double room = followed / std::max(h * steepest, 1e-20) - h;
    const double damping = std::min(asked, std::max(room, 4.0 * h));
    const double share = std::min(1.0, followed / std::max(h * (h + damping) * steepest, 1e-20));
    out.steepest = share * steepest;
    out.stiffness = static_cast<float>(share) * e.stiffness;
    out.damping = static_cast<float>(damping);
    return out;
}

Chebyshev::Chebyshev(uint32_t n)
{
    // What may be left of the error of any strain, which it may be overshot by. Steep ones, which few iterations do not
    // follow, swing up by BDF2 where they are overshot by more than 0.17.
    const double left = n <= 5 ? 0.3 : 0.15;
    const double shift = std::cosh(std::acosh(1.0 / left) / n);
    least = (shift - 1.0) / (shift + 1.0);
    cosine = std::cos(std::numbers::pi / (2.0 * n));
}

double Chebyshev::followed() const
{
    // The smallest root, as a share of the largest eigenvalue, is (1 + least - (1 - least) cosine) / 2.
    return 2.0 / (1.0 + least - (1.0 - least) * cosine) - 1.0;
}

}  // namespace knuckle
