#include "sim/solver/soft_step.h"

namespace knuckle {

SoftStep::SoftStep(const std::function<Kernel(const char* name, Defines defines)>& load, const SolverBuffers& buffers)
    : clusters_(groupsFor(buffers.parameters.clusterCount)), particles_(groupsFor(buffers.parameters.softCount))
{
    const Defines first = {{"FIRST", "1"}};
    clusterMatchFirst_ = load("cluster_match", first);
    clusterMatch_ = load("cluster_match", {});
    clusterPullFirst_ = load("cluster_pull", first);
    clusterPull_ = load("cluster_pull", {});
}

void SoftStep::run(KernelTimer& timer, bool first) const
{
    (first ? clusterMatchFirst_ : clusterMatch_).dispatch(timer, clusters_);
    (first ? clusterPullFirst_ : clusterPull_).dispatch(timer, particles_);
}

}  // namespace knuckle
