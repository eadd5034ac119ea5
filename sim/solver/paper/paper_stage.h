#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// The paper's own solver (section 3): Macklin et al. 2014, algorithm 1, on single particles, to which each body is
/// matched. It predicts, the search for contacts follows, then it solves.
class PaperStage : public Stage {
public:
    explicit PaperStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    void predict(Recorder& recorder) const;
    /// Stabilization, iterations, velocities and positions.
    void solve(Recorder& recorder) const;

    /// A step of eq. 10: the links whose partial sum adds another's.
    struct ReductionStep {
        uint32_t begin = 0, end = 0;  ///< In reductionLinks.
        uint32_t stride = 1;          ///< The other link is so many links further.
    };
    std::vector<ReductionStep> reductionSteps;  ///< ceil(log2 p), p being the links of the largest body (eq. 10).

    Buffer<gpu::vec4> oldMoves, oldVelocities;  ///< The last substep's move, the velocity before it: for BDF2.
    Buffer<gpu::vec4> predicted;                ///< Move since the substep began, x* - x.
    Buffer<gpu::vec4> moved;                    ///< The same plus what contacts ask for.
    Buffer<gpu::vec4> bodyStarts;               ///< Per body, two: centre and rotation when the substep began.
    Buffer<gpu::vec4> bodyMatrices;             ///< Per body: three columns of A.
    Buffer<gpu::uvec2> bodyActing;    ///< Per body: how much of it the pushed particles move; the sum of this iteration
                                      ///< and that of the last (contact_average.comp).
    Buffer<float> linkGains;          ///< Per link of a shared particle: how far beyond the mean of goals it is placed
                                      ///< in the match, in distances of goal and mean.
    Buffer<gpu::vec4> linkPulls;      ///< ... and that offset from the mean [m].
    Buffer<gpu::vec4> linkTerms;      ///< Per link, three: eq. 10.
    Buffer<uint32_t> reductionLinks;  ///< Links of each ReductionStep, one step after another.

private:
    void stabilize(Recorder& recorder) const;
    /// Matches each body to its particles: eqs. 9-18.
    void match(Recorder& recorder) const;
    /// The sums of eq. 9 by eq. 10.
    void reduceInSteps(Recorder& recorder) const;
    void reduce(Recorder& recorder, const Kernel& terms, const Kernel& step, const Kernel& collect) const;

    const gpu::StepParameters& parameters_;
    uint32_t stabilization_, iterations_;
    ReductionKind reduction_;
    bool hasShared_, inSteps_;
    Pass predict_{*this, "paper/predict"};
    Pass bodyStart_{*this, "paper/body_start"};
    Pass contactStabilize_{*this, "paper/contact_average", {{"STABILIZE", "1"}}};
    Pass shapeStabilize_{*this, "paper/shape_goals", {{"STABILIZE", "1"}}};
    Pass jointStabilize_{*this, "paper/joint_goals", {{"STABILIZE", "1"}}, hasShared_};
    Pass contactAverage_{*this, "paper/contact_average"};
    Pass bodySum_{*this, "paper/body_sum", {}, reduction_ == ReductionKind::Thread};
    Pass bodySumGroup_{*this, "paper/body_sum_group", {}, reduction_ == ReductionKind::Group};
    Pass linkCentreTerms_{*this, "paper/link_terms", {{"CENTRES", "1"}}, inSteps_};
    Pass linkMatrixTerms_{*this, "paper/link_terms", {}, inSteps_};
    Pass linkCentreReduce_{*this, "paper/link_reduce", {{"CENTRES", "1"}}, inSteps_};
    Pass linkMatrixReduce_{*this, "paper/link_reduce", {}, inSteps_};
    Pass bodyCollectCentres_{*this, "paper/body_collect", {{"CENTRES", "1"}}, inSteps_};
    Pass bodyCollectMatrices_{*this, "paper/body_collect", {}, inSteps_};
    Pass bodyRotation_{*this, "paper/body_rotation"};
    Pass shapeGoals_{*this, "paper/shape_goals"};
    Pass jointGoals_{*this, "paper/joint_goals", {}, hasShared_};
    Pass finish_{*this, "paper/finish"};
};

}  // namespace knuckle
