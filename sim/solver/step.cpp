// The story of a step.
//
// A step of Settings::timeStep is cut into substeps; small substeps with one iteration each are stiffer than one step
// with many (Macklin et al. 2019). A substep
//
//   predicts where each particle would be if nothing touched it (predict);
//   finds the particles and colliders that each may touch, but only when some particle has used up its margin since
//     they were last found: find_due sets the sizes of those dispatches on the GPU, to zero otherwise. The neighbour
//     grid is a counting sort: count, prefix sum, scatter, and an order within the cell that does not depend on the
//     order of arrival (grid_*);
//   solves contacts and joints, body by body. A body is a block of links (the paper's listing 1). Its particles move
//     as they like, then the body is matched to them: mass centre and matrix A (body_sum, eq. 9), rotation
//     (body_rotation, eqs. 11-17), and each particle goes to its goal Q r + c, or to the mean of its goals where bodies
//     share it (shape_goals and joint_goals, eq. 8): that is the joint;
//   finishes with velocities and positions.
//
// The default solver works with impulses. Those of contacts live on from substep to substep: contact_warm applies what
// the last one needed; after a first match the bodies stand where that leaves them, and contact_solve (for contacts)
// and joint_goals (for joints) work out what is still missing. An impulse on a particle is a displacement of that
// particle alone; shape matching spreads it over the body as the impulse itself would have.
//
// The paper's solver moves each particle by the average of its overlaps instead (contact_average), without memory.
#include "sim/solver/step.h"

#include <bit>

namespace knuckle {

namespace {

enum Dispatch : uint32_t { PARTICLES, CELLS, CHUNKS, ONE };

}  // namespace

Step::Step(const Gpu& gpu, SolverBuffers& buffers, const Settings& settings)
    : settings_(settings), buffers_(buffers), particles_(groupsFor(buffers.parameters.particleCount)),
      bodies_(groupsFor(buffers.parameters.bodyCount)), links_(groupsFor(buffers.parameters.linkCount)),
      shared_(groupsFor(buffers.parameters.sharedCount))
{
    const BufferTable table = buffers.table();
    const auto load = [&](const char* name, const Defines& defines = {}) {
        return Kernel(gpu, table, std::string("sim/") + name + ".comp", defines);
    };
    // The paper's stabilization and freezing leave particles off their goals.
    const Defines shape = settings.solver == SolverKind::Paper ? Defines{{"FROM_POSITIONS", "1"}} : Defines{};
    Defines centres = shape;
    centres.push_back({"CENTRES", "1"});
    const Defines grid = settings.grid == GridKind::Hash ? Defines{{"GRID_HASH", "1"}} : Defines{};
    predict_ = load("predict");
    findDue_ = load("find_due");
    gridClear_ = load("grid_clear");
    gridCount_ = load("grid_count", grid);
    gridChunkSum_ = load("grid_chunk_sum");
    gridChunkScan_ = load("grid_chunk_scan");
    gridCellStart_ = load("grid_cell_start");
    gridScatter_ = load("grid_scatter");
    gridOrder_ = load("grid_order");
    contactFind_ = load("contact_find", grid);
    colliderFind_ = load("collider_find");
    if (settings.solver == SolverKind::Impulse) {
        contactWarm_ = load("contact_warm");
        contactSolve_ = load("contact_solve");
    } else {
        contactAverage_ = load("contact_average");
        contactStabilize_ = load("contact_average", {{"STABILIZE", "1"}});
        stabilizeApply_ = load("stabilize_apply");
    }
    if (settings.reduction == ReductionKind::Steps) {
        linkCentreTerms_ = load("link_terms", centres);
        linkMatrixTerms_ = load("link_terms", shape);
        linkReduce_ = load("link_reduce");
        bodyCollectCentres_ = load("body_collect", {{"CENTRES", "1"}});
        bodyCollectMatrices_ = load("body_collect");
    } else
        bodySum_ = load(settings.reduction == ReductionKind::Group ? "body_sum_group" : "body_sum", shape);
    bodyStart_ = load("body_start");
    bodyRotation_ = load(settings.rotation == RotationMethod::Householder ? "body_rotation_householder"
                                                                          : "body_rotation");
    shapeGoals_ = load("shape_goals");
    jointGoals_ = load("joint_goals");
    jointGoalsLast_ = load("joint_goals", {{"LAST", "1"}});
    finish_ = load("finish");
}

void Step::run(KernelTimer& timer) const
{
    for (uint32_t i = 0; i < settings_.substeps; ++i) substep(timer);
}

void Step::substep(KernelTimer& timer) const
{
    predict_.dispatch(timer, particles_);
    bodyStart_.dispatch(timer, bodies_);
    findContacts(timer);
    if (settings_.solver == SolverKind::Impulse) impulseIterations(timer);
    else paperIterations(timer);
    finish_.dispatch(timer, particles_);
}

void Step::findContacts(KernelTimer& timer) const
{
    const RawBuffer& sizes = buffers_.dispatches;
    findDue_.dispatch(timer, 1);
    gridClear_.dispatchIndirect(timer, sizes, CELLS);
    gridCount_.dispatchIndirect(timer, sizes, PARTICLES);
    gridChunkSum_.dispatchIndirect(timer, sizes, CHUNKS);
    gridChunkScan_.dispatchIndirect(timer, sizes, ONE);
    gridCellStart_.dispatchIndirect(timer, sizes, CHUNKS);
    gridScatter_.dispatchIndirect(timer, sizes, PARTICLES);
    gridOrder_.dispatchIndirect(timer, sizes, PARTICLES);
    contactFind_.dispatchIndirect(timer, sizes, PARTICLES);
    colliderFind_.dispatchIndirect(timer, sizes, PARTICLES);
}

void Step::impulseIterations(KernelTimer& timer) const
{
    contactWarm_.dispatch(timer, particles_);
    matchShapes(timer, false);
    for (uint32_t i = 1; i <= settings_.iterations; ++i) {
        contactSolve_.dispatch(timer, particles_);
        matchShapes(timer, i == settings_.iterations);
    }
}

void Step::paperIterations(KernelTimer& timer) const
{
    for (uint32_t i = 0; i < settings_.stabilization; ++i) {
        contactStabilize_.dispatch(timer, particles_);
        stabilizeApply_.dispatch(timer, particles_);
    }
    for (uint32_t i = 1; i <= settings_.iterations; ++i) {
        contactAverage_.dispatch(timer, particles_);
        matchShapes(timer, i == settings_.iterations);
    }
}

void Step::matchShapes(KernelTimer& timer, bool last) const
{
    if (settings_.reduction == ReductionKind::Steps) reduceInSteps(timer);
    else if (settings_.reduction == ReductionKind::Group) bodySum_.dispatch(timer, buffers_.parameters.bodyCount);
    else bodySum_.dispatch(timer, bodies_);
    bodyRotation_.dispatch(timer, bodies_);
    shapeGoals_.dispatch(timer, particles_);
    if (shared_ > 0) (last ? jointGoalsLast_ : jointGoals_).dispatch(timer, shared_);
}

void Step::reduceInSteps(KernelTimer& timer) const
{
    const auto reduce = [&](const Kernel& terms, const Kernel& collect) {
        terms.dispatch(timer, links_);
        for (uint32_t stride = 1; stride < buffers_.longestBody; stride *= 2) {
            glProgramUniform1ui(linkReduce_.program(), 0, stride);
            linkReduce_.dispatch(timer, links_);
        }
        collect.dispatch(timer, bodies_);
    };
    reduce(linkCentreTerms_, bodyCollectCentres_);
    reduce(linkMatrixTerms_, bodyCollectMatrices_);
}

}  // namespace knuckle
