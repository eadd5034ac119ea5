#include "sim/solver/paper/paper_step.h"

namespace knuckle {

namespace {

const Defines STABILIZE{{"STABILIZE", "1"}};

}  // namespace

PaperStep::PaperStep(const LoadKernel& load, SolverBuffers& buffers, const Settings& settings)
    : buffers_(buffers), settings_(settings), particles_(groupsFor(buffers.parameters.particleCount)),
      bodies_(groupsFor(buffers.parameters.bodyCount)), links_(groupsFor(buffers.parameters.linkCount)),
      shared_(groupsFor(buffers.parameters.sharedCount))
{
    predict_ = load("paper/predict", {});
    bodyStart_ = load("paper/body_start", {});
    contactStabilize_ = load("paper/contact_average", STABILIZE);
    shapeStabilize_ = load("paper/shape_goals", STABILIZE);
    jointStabilize_ = load("paper/joint_goals", STABILIZE);
    contactAverage_ = load("paper/contact_average", {});
    loadSums(load);
    bodyRotation_ = load("paper/body_rotation", {});
    shapeGoals_ = load("paper/shape_goals", {});
    jointGoals_ = load("paper/joint_goals", {});
    finish_ = load("paper/finish", {});
}

void PaperStep::loadSums(const LoadKernel& load)
{
    if (settings_.reduction != ReductionKind::Steps) {
        bodySum_ = load(settings_.reduction == ReductionKind::Group ? "paper/body_sum_group" : "paper/body_sum", {});
        return;
    }
    const Defines centres = {{"CENTRES", "1"}};
    linkCentreTerms_ = load("paper/link_terms", centres);
    linkMatrixTerms_ = load("paper/link_terms", {});
    linkCentreReduce_ = load("paper/link_reduce", centres);
    linkMatrixReduce_ = load("paper/link_reduce", {});
    bodyCollectCentres_ = load("paper/body_collect", centres);
    bodyCollectMatrices_ = load("paper/body_collect", {});
}

void PaperStep::predict(KernelTimer& timer) const
{
    predict_.dispatch(timer, particles_);
    if (bodies_ > 0) bodyStart_.dispatch(timer, bodies_);
}

void PaperStep::solve(KernelTimer& timer) const
{
    for (uint32_t i = 0; i < settings_.stabilization; ++i) stabilize(timer);
    for (uint32_t i = 0; i < settings_.iterations; ++i) {
        contactAverage_.dispatch(timer, particles_);
        match(timer);
        shapeGoals_.dispatch(timer, particles_);
        if (shared_ > 0) jointGoals_.dispatch(timer, shared_);
    }
    finish_.dispatch(timer, particles_);
}

void PaperStep::stabilize(KernelTimer& timer) const
{
    contactStabilize_.dispatch(timer, particles_);
    match(timer);
    shapeStabilize_.dispatch(timer, particles_);
    if (shared_ > 0) jointStabilize_.dispatch(timer, shared_);
    if (bodies_ > 0) bodyStart_.dispatch(timer, bodies_);
}

void PaperStep::match(KernelTimer& timer) const
{
    if (bodies_ == 0) return;
    if (settings_.reduction == ReductionKind::Steps) reduceInSteps(timer);
    else if (settings_.reduction == ReductionKind::Group) bodySum_.dispatch(timer, buffers_.parameters.bodyCount);
    else bodySum_.dispatch(timer, bodies_);
    bodyRotation_.dispatch(timer, bodies_);
}

void PaperStep::reduceInSteps(KernelTimer& timer) const
{
    const auto reduce = [&](const Kernel& terms, const Kernel& step, const Kernel& collect) {
        terms.dispatch(timer, links_);
        for (const ReductionStep& s : buffers_.reductionSteps) {
            glProgramUniform3ui(step.program(), 0, s.begin, s.end, s.stride);
            step.dispatch(timer, groupsFor(s.end - s.begin));
        }
        collect.dispatch(timer, bodies_);
    };
    reduce(linkCentreTerms_, linkCentreReduce_, bodyCollectCentres_);
    reduce(linkMatrixTerms_, linkMatrixReduce_, bodyCollectMatrices_);
}

}  // namespace knuckle
