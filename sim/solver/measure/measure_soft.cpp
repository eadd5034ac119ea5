#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/solver/layout/cluster_links.h"
#include "sim/solver/measure/measure.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The principal stretches of the linear map nearest to a cluster's particles; 1 where it has no extent.
Vector3d stretches(const World& world, const Cluster& cluster, const ParticleState& particles,
                   const ClusterMoments& moments)
{
    const Vector3d origin = particles.positions[world.clusterLinks[cluster.linkStart].particle].cast<double>();
    Matrix3d sum = Matrix3d::Zero();
    for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l) {
        const Link& link = world.clusterLinks[l];
        const Vector3d arm = particles.positions[link.particle].cast<double>() - origin;
        sum += link.mass * arm * link.restOffset.cast<double>().transpose();
    }
    const Matrix3d map = sum * moments.inverse;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(map.transpose() * map + moments.empty, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace

void measureSoftBodies(Measures& out, const World& world, const ParticleState& particles)
{
    double strains = 0.0, mass = 0.0;
    for (const SoftBody& soft : world.softBodies) {
        double volume = 0.0, softMass = 0.0;
        for (uint32_t c = soft.clusterStart; c < soft.clusterStart + soft.clusterCount; ++c) {
            const ClusterMoments moments = clusterMoments(world, world.clusters[c]);
            const Vector3d stretch = stretches(world, world.clusters[c], particles, moments);
            const double strain = (stretch - Vector3d::Ones()).norm();
            out.worstSoftStrain = std::max(out.worstSoftStrain, static_cast<float>(strain));
            strains += moments.mass * strain;
            volume += moments.mass * stretch.prod();
            softMass += moments.mass;
        }
        if (softMass == 0.0) continue;
        mass += softMass;
        const auto error = static_cast<float>(std::abs(volume / softMass - 1.0));
        out.softVolumeError = std::max(out.softVolumeError, error);
    }
    if (mass > 0.0) out.meanSoftStrain = static_cast<float>(strains / mass);
}

}  // namespace knuckle
