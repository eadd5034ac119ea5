#pragma once

#include <vector>

#include "sim/solver/stage.h"

namespace knuckle {

/// Soft bodies: overlapping clusters that are matched to their particles and pull them (Mueller et al. 2005). Their
/// links follow those of bodies in BodyStage::links.
class SoftStage : public Stage {
public:
    static bool isNeeded(const World& world);
    explicit SoftStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// As many of their own iterations as are due in this one. @param iteration of `count` in the substep, from 0 on.
    void solve(Recorder& recorder, uint32_t iteration, uint32_t count) const;

    Buffer<gpu::Cluster> clusterInfo;    ///< Per cluster.
    Buffer<gpu::vec4> clusterMoments;    ///< Per cluster, four: inverse moments; directions without particles.
    Buffer<gpu::SoftMatter> softMatter;  ///< Per soft body.
    Buffer<gpu::uvec4> softParticles;    ///< Per soft particle: mover, rank, first entry and count in softLinks.
    Buffer<uint32_t> softLinks;          ///< Links of soft particles, grouped by particle.
    Buffer<gpu::vec4> clusterRotations;  ///< Per cluster: quaternion.
    Buffer<gpu::vec4> clusterRests;      ///< Per cluster: three columns of what it has flowed by.
    Buffer<gpu::vec4> clusterPulls;      ///< Per cluster, five: what pulls its particles (cluster_match.comp).
    Buffer<gpu::vec4> softImpulses;      ///< Per soft particle, two: from its clusters in this substep; last change.

private:
    void uploadClusters(const StageSetup& setup);
    void uploadParticles(const StageSetup& setup);

    const gpu::StepParameters& parameters_;
    struct Span {
        uint32_t begin = 0, end = 0;
    };
    struct Paced {
        uint32_t iterations;
        Span clusters, particles;
    };
    std::vector<Paced> paced_;  ///< Per body.
    uint32_t iterations_ = 1;   ///< A substep, of the body that needs most.
    Pass matchFirst_{*this, "soft/cluster_match", {{"FIRST_ITERATION", "1"}}};
    Pass match_{*this, "soft/cluster_match"};
    Pass pullFirst_{*this, "soft/cluster_pull", {{"FIRST_ITERATION", "1"}}};
    Pass pull_{*this, "soft/cluster_pull"};
};

}  // namespace knuckle
