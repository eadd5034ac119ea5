#include "sim/solver/soft/soft_step.h"

#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

/// The root of an iteration, in 0 ... 1, the largest first: of the Chebyshev polynomial that leaves at most MOST_LEFT
/// of what any strain asks for, however steep. (In a plain Jacobi iteration all are 1, and what is smooth is slow.)
float rootOf(uint32_t iteration, uint32_t count)
{
    constexpr float MOST_LEFT = 0.3f;
    const auto n = static_cast<float>(count);
    const float shift = std::cosh(std::acosh(1.0f / MOST_LEFT) / n);
    const float angle = std::numbers::pi_v<float> * (n - static_cast<float>(iteration) - 0.5f) / n;
    return (shift - std::cos(angle)) / (shift + 1.0f);
}

}  // namespace

SoftStep::SoftStep(const LoadKernel& load, const SolverBuffers& buffers)
    : clusters_(groupsFor(buffers.parameters.clusterCount)), particles_(groupsFor(buffers.parameters.softCount))
{
    const Defines first = {{"FIRST_ITERATION", "1"}};
    clusterMatchFirst_ = load("soft/cluster_match", first);
    clusterMatch_ = load("soft/cluster_match", {});
    clusterPullFirst_ = load("soft/cluster_pull", first);
    clusterPull_ = load("soft/cluster_pull", {});
}

void SoftStep::run(KernelTimer& timer, uint32_t iteration, uint32_t count) const
{
    const Kernel& pull = iteration == 0 ? clusterPullFirst_ : clusterPull_;
    glProgramUniform1f(pull.program(), 0, rootOf(iteration, count));
    (iteration == 0 ? clusterMatchFirst_ : clusterMatch_).dispatch(timer, clusters_);
    pull.dispatch(timer, particles_);
}

}  // namespace knuckle
