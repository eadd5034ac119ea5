// The story of a step.
//
// A step of Settings::timeStep is cut into substeps; small substeps with few iterations are stiffer than one step with
// many (Macklin et al. 2019). What moves is a mover: a body, or a loose particle. The particles of a rigid body always
// move as a linear field over it, so the default solver predicts, matches and finishes bodies through fields
// (shaders/sim/common/fields.glsl) and visits their particles only where something touches them. A substep
//
//   predicts how far each mover would move if nothing touched it, adds what its contacts did last, and asks for a new
//     search when it has left its margin (mover_predict);
//   finds contacts, but only when somebody asked: search_due sets the sizes of those dispatches on the GPU, to zero
//     otherwise. Particles are placed (search_position) and sorted into cells by a counting sort (grid_*); each looks for
//     those that lie ahead (contact_find, further for fast ones: contact_find_far) and for colliders (collider_*); a
//     prefix sum gives each list its place (scan_*, list_start, pair_list), and each contact learns what it is made of
//     (contact_prepare, collider_prepare);
//   moves fluids by their pressures (fluid_*), once;
//   solves, `iterations` times: cluster_match and cluster_pull pull soft bodies together, distance_solve moves ropes and
//     cloth, phase by phase; contact_solve, collider_solve and joint_solve work out impulses, each contact and joint by
//     itself, from where the movers are; mover_solve sums them for each mover and matches it (eqs. 8-9, 11-17) to where
//     they bring its particles;
//   finishes with velocities and places (mover_integrate), and where materials have restitution, gives collisions the
//     speeds at which they part (contact_restitution, collider_restitution, mover_restitution).
//
// With Settings::sleepSpeed, what has been calm for long sleeps from the end of a step on (sleep_mover, sleep_island,
// sleep_update), until something that moves comes near it (sleep_wake_island, sleep_wake_assembly, in each substep).
//
// A step ends with its particles where their bodies have them (particle_position); those that bodies share stand at the
// mean of their goals, which is the joint (joint_position). Where there are emitters or drains, fluid particles then leave
// the pools (emitter_update, pool_order, fluid_emit) or go back to them (fluid_drain).
//
// Freezing (Settings::freeze) is the same for each assembly by itself: freeze_mover, freeze_update at the end of a step.
//
// The paper's solver does all of this particle by particle (PaperStep): predict, then contact_average (each particle
// moves by the average of its overlaps), then each body is matched to its particles (body_sum, body_rotation) and they
// go to their goals (shape_goals, joint_goals), once with STABILIZE and then `iterations` times, and finish.
#include "sim/solver/step.h"

namespace knuckle {

Step::Step(const Gpu& gpu, SolverBuffers& buffers, const Settings& settings)
    : settings_(settings), mayRest_(settings.sleepSpeed > 0.0f || settings.freeze > 0.0f), buffers_(buffers),
      particles_(groupsFor(buffers.parameters.particleCount)),
      movers_(groupsFor(buffers.parameters.moverCount)), bodies_(groupsFor(buffers.parameters.bodyCount)),
      loose_(groupsFor(buffers.parameters.moverCount - buffers.parameters.bodyCount)),
      assemblies_(groupsFor(buffers.parameters.assemblyCount)),
      shared_(groupsFor(buffers.parameters.sharedCount)),
      sharedByTwo_(groupsFor(buffers.parameters.sharedByTwo)),
      sharedByMany_(groupsFor(buffers.parameters.sharedCount - buffers.parameters.sharedByTwo))
{
    const BufferTable table = buffers.table();
    const LoadKernel load = [&](const char* name, Defines defines) {
        if (settings.rotation == RotationMethod::Householder) defines.push_back({"HOUSEHOLDER", "1"});
        if (settings.rotation == RotationMethod::Higham) defines.push_back({"HIGHAM", "1"});
        if (settings.massScaling > 0.0f) defines.push_back({"MASS_SCALING", "1"});
        if (mayRest_) defines.push_back({"SLEEP", "1"});
        if (settings.freeze > 0.0f) defines.push_back({"FREEZE", "1"});
        if (buffers.hasPool) defines.push_back({"POOL", "1"});
        if (buffers.hasGrids) defines.push_back({"GRIDS", "1"});
        if (settings.grid == GridKind::Hash) defines.push_back({"GRID_HASH", "1"});
        return Kernel(gpu, table, std::string("sim/") + name + ".comp", defines);
    };
    loadSearch(load);
    if (settings.solver == SolverKind::Impulse) loadImpulseSolver(load);
    else paper_.emplace(load, buffers, settings);
    if (mayRest_) loadSleep(load);
    if (buffers.parameters.fluidCount > 0) fluid_.emplace(load, buffers, settings);
    if (buffers.hasPool) fluidPool_.emplace(load, buffers);
    if (settings.solver == SolverKind::Impulse) distanceStep_ = DistanceStep(gpu, buffers);
}

void Step::loadSearch(const LoadKernel& load)
{
    const Defines place = settings_.solver == SolverKind::Paper ? Defines{{"FROM_POSITIONS", "1"}} : Defines{};
    const Defines lists = {{"LISTS", "1"}};
    searchDue_ = load("search/search_due", {});
    moverReach_ = load("search/mover_reach", {});
    searchFarDue_ = load("search/search_far_due", {});
    searchPosition_ = load("search/search_position", place);
    gridClear_ = load("search/grid_clear", {});
    gridCount_ = load("search/grid_count", {});
    gridSum_ = load("search/scan_sum", {});
    gridChunks_ = load("search/scan_chunks", {});
    gridStart_ = load("search/grid_start", {});
    gridScatter_ = load("search/grid_scatter", {});
    gridOrder_ = load("search/grid_order", {});
    contactFind_ = load("search/contact_find", {});
    contactFindFar_ = load("search/contact_find_far", {});
    colliderNear_ = load("search/collider_near", {});
    colliderFind_ = load("search/collider_find", {});
    listSum_ = load("search/scan_sum", lists);
    listChunks_ = load("search/scan_chunks", lists);
    listStart_ = load("search/list_start", lists);
    pairList_ = load("search/pair_list", {});
    contactPrepare_ = load("contact/contact_prepare", {});
    colliderPrepare_ = load("contact/collider_prepare", {});
}

void Step::loadImpulseSolver(const LoadKernel& load)
{
    const auto loadForMovers = [&](const char* name, Defines defines) {
        Defines bodies = defines, loose = defines;
        bodies.push_back({"BODIES", "1"});
        loose.push_back({"LOOSE", "1"});
        return ForMovers{load(name, bodies), load(name, loose)};
    };
    moverPredict_ = loadForMovers("body/mover_predict", {});
    if (buffers_.hasParticleImpulses) impulseClear_ = load("contact/impulse_clear", {});
    moverWarmStart_ = load("body/mover_solve", {{"WARM_START", "1"}});
    contactSolve_ = load("contact/contact_solve", {});
    colliderSolve_ = load("contact/collider_solve", {});
    jointSolveFirst_ = load("joint/joint_solve", {{"FIRST_ITERATION", "1"}});
    jointSolve_ = load("joint/joint_solve", {});
    jointSolveManyFirst_ = load("joint/joint_solve_many", {{"FIRST_ITERATION", "1"}});
    jointSolveMany_ = load("joint/joint_solve_many", {});
    moverSolve_ = loadForMovers("body/mover_solve", buffers_.hasParticleImpulses ? Defines{{"ON_PARTICLES", "1"}} : Defines{});
    moverIntegrate_ = loadForMovers("body/mover_integrate", {});
    particlePosition_ = load("body/particle_position", {});
    jointPosition_ = load("joint/joint_position", {});
    if (buffers_.hasRestitution) loadRestitution(load);
    if (buffers_.parameters.clusterCount > 0) soft_.emplace(load, buffers_);
}

void Step::loadRestitution(const LoadKernel& load)
{
    contactDetect_ = load("restitution/contact_restitution", {{"DETECT", "1"}});
    colliderDetect_ = load("restitution/collider_restitution", {{"DETECT", "1"}});
    contactRestitution_ = load("restitution/contact_restitution", {});
    colliderRestitution_ = load("restitution/collider_restitution", {});
    contactRestitutionEager_ = load("restitution/contact_restitution", {{"EAGER", "1"}});
    colliderRestitutionEager_ = load("restitution/collider_restitution", {{"EAGER", "1"}});
    moverRestitution_ = load("restitution/mover_restitution", {});
}

void Step::loadSleep(const LoadKernel& load)
{
    if (settings_.freeze > 0.0f) {
        freezeMover_ = load("sleep/freeze_mover", {});
        freezeUpdate_ = load("sleep/freeze_update", {});
    } else {
        sleepMover_ = load("sleep/sleep_mover", {});
        sleepIsland_ = load("sleep/sleep_island", {});
        sleepUpdate_ = load("sleep/sleep_update", {});
    }
    sleepWakeIsland_ = load("sleep/sleep_wake_island", {});
    sleepWakeAssembly_ = load("sleep/sleep_wake_assembly", {});
}

void Step::settle(KernelTimer& timer) const
{
    if (fluid_) fluid_->settle(timer);
}

void Step::run(KernelTimer& timer) const
{
    const bool paper = settings_.solver == SolverKind::Paper;
    if (fluid_) fluid_->findNeighbours(timer);
    for (uint32_t i = 0; i < settings_.substeps; ++i) paper ? paperSubstep(timer) : impulseSubstep(timer, i == 0);
    if (settings_.sleepSpeed > 0.0f) fallAsleep(timer);
    if (!paper) {
        particlePosition_.dispatch(timer, particles_);
        if (shared_ > 0) jointPosition_.dispatch(timer, shared_);
    }
    if (settings_.freeze > 0.0f) freeze(timer);
    if (fluidPool_) fluidPool_->run(timer);
}

void Step::findContacts(KernelTimer& timer) const
{
    const RawBuffer& sizes = buffers_.dispatches;
    const bool paper = settings_.solver == SolverKind::Paper;   // its bodies are particles until the end of a step
    searchDue_.dispatch(timer, 1);
    if (!paper) moverReach_.dispatchIndirect(timer, sizes, DISPATCH_MOVERS);
    searchPosition_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    searchFarDue_.dispatchIndirect(timer, sizes, DISPATCH_ONE);
    gridClear_.dispatchIndirect(timer, sizes, DISPATCH_CELLS);
    gridCount_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    gridSum_.dispatchIndirect(timer, sizes, DISPATCH_CELL_CHUNKS);
    gridChunks_.dispatchIndirect(timer, sizes, DISPATCH_ONE);
    gridStart_.dispatchIndirect(timer, sizes, DISPATCH_CELL_CHUNKS);
    gridScatter_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    gridOrder_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    contactFind_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    contactFindFar_.dispatchIndirect(timer, sizes, DISPATCH_FAST);
    if (!paper) colliderNear_.dispatchIndirect(timer, sizes, DISPATCH_MOVERS);
    colliderFind_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    listSum_.dispatchIndirect(timer, sizes, DISPATCH_LIST_CHUNKS);
    listChunks_.dispatchIndirect(timer, sizes, DISPATCH_ONE);
    listStart_.dispatchIndirect(timer, sizes, DISPATCH_LIST_CHUNKS);
    pairList_.dispatchIndirect(timer, sizes, DISPATCH_PARTICLES);
    contactPrepare_.dispatchIndirect(timer, sizes, DISPATCH_NEW_PAIRS);
    colliderPrepare_.dispatchIndirect(timer, sizes, DISPATCH_NEW_COLLIDER_PAIRS);
}

void Step::dispatch(KernelTimer& timer, const ForMovers& kernels) const
{
    if (bodies_ > 0) kernels.bodies.dispatch(timer, bodies_);
    if (loose_ > 0) kernels.loose.dispatch(timer, loose_);
}

void Step::impulseSubstep(KernelTimer& timer, bool first) const
{
    if (particles_ == 0) {
        searchDue_.dispatch(timer, 1);   // counts the substep
        fluid_->substep(timer, first);
        return;
    }
    const RawBuffer& sizes = buffers_.dispatches;
    dispatch(timer, moverPredict_);
    if (buffers_.hasParticleImpulses) impulseClear_.dispatch(timer, particles_);
    findContacts(timer);
    wake(timer);
    moverWarmStart_.dispatchIndirect(timer, sizes, DISPATCH_MOVERS);
    if (fluid_) fluid_->substep(timer, first);
    for (uint32_t i = 0; i < settings_.iterations; ++i) {
        if (soft_) soft_->run(timer, i, settings_.iterations);
        distanceStep_.run(timer, i == 0);
        contactSolve_.dispatchIndirect(timer, sizes, DISPATCH_PAIRS);
        colliderSolve_.dispatchIndirect(timer, sizes, DISPATCH_COLLIDER_PAIRS);
        if (sharedByTwo_ > 0) (i == 0 ? jointSolveFirst_ : jointSolve_).dispatch(timer, sharedByTwo_);
        if (sharedByMany_ > 0) (i == 0 ? jointSolveManyFirst_ : jointSolveMany_).dispatch(timer, sharedByMany_);
        dispatch(timer, moverSolve_);
    }
    dispatch(timer, moverIntegrate_);
    if (buffers_.hasRestitution) bounce(timer);
}

void Step::bounce(KernelTimer& timer) const
{
    const auto iterate = [&](const Kernel& contacts, const Kernel& colliders) {
        contacts.dispatchIndirect(timer, buffers_.dispatches, DISPATCH_PAIRS);
        colliders.dispatchIndirect(timer, buffers_.dispatches, DISPATCH_COLLIDER_PAIRS);
        moverRestitution_.dispatch(timer, movers_);
    };
    iterate(contactDetect_, colliderDetect_);
    for (uint32_t i = 0; i < RESTITUTION_ROUNDS; ++i) {
        iterate(contactRestitution_, colliderRestitution_);
        iterate(contactRestitutionEager_, colliderRestitutionEager_);
    }
}

void Step::wake(KernelTimer& timer) const
{
    if (!mayRest_) return;
    sleepWakeIsland_.dispatchIndirect(timer, buffers_.dispatches, DISPATCH_PAIRS);
    sleepWakeAssembly_.dispatch(timer, assemblies_);
}

void Step::freeze(KernelTimer& timer) const
{
    freezeMover_.dispatch(timer, movers_);
    freezeUpdate_.dispatch(timer, assemblies_);
}

void Step::fallAsleep(KernelTimer& timer) const
{
    sleepMover_.dispatch(timer, movers_);
    sleepIsland_.dispatchIndirect(timer, buffers_.dispatches, DISPATCH_PAIRS);
    sleepUpdate_.dispatch(timer, assemblies_);
}

void Step::paperSubstep(KernelTimer& timer) const
{
    paper_->predict(timer);
    findContacts(timer);
    wake(timer);
    paper_->solve(timer);
}

}  // namespace knuckle
