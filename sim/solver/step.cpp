// The passes of a step.
//
// A step of Settings::timeStep is cut into substeps; small substeps with few iterations are stiffer than one step with
// many (Macklin et al. 2019). A mover is a body or a loose particle. The particles of a rigid body always move as a
// linear field over it, so the default solver predicts, matches and finishes bodies through fields
// (shaders/sim/common/bodies/fields.glsl) and visits their particles only where something touches them. A substep
//
//   lets go of what is held until now (mover_release), and takes hold of what was caught (drive_catch);
//   moves animated bodies and colliders (animate, collider_move), and notes how far driven bodies are from their
//     clips (drive_*, again below) and how far joints of motors are turned (motor_begin);
//   predicts how far each mover would move if nothing touched it, and adds what its contacts did last (mover_predict,
//     jointed_predict), and asks for a new search where one has left its margin (mover_drift);
//   finds contacts, but only when asked: search_due sets the sizes of those dispatches on the GPU, to zero
//     otherwise. Movers and particles get the places to search for (search_centre, search_position), particles are
//     sorted into cells by a counting sort (grid_*); each looks for those that lie ahead (contact_find, further for
//     fast ones: contact_find_far) and for colliders (collider_*); a prefix sum says where each list begins (scan_*,
//     list_start, pair_list), and each contact gets its data (contact_prepare, collider_prepare);
//   moves fluids by their pressures (fluid_*), once, and slows them by their viscosity (viscous_*);
//   solves, `iterations` times: cluster_match and cluster_pull pull soft bodies together, strand_solve moves ropes
//     and cloth, colour by colour, ropes with their contacts with colliders (rope_touch, rope_push); contact_solve and
//     collider_solve work out impulses, each contact by itself, from where the movers are, drive_* the pull of
//     springs towards clips, motor_turn that of joints' motors; impulse_sum adds them up for each body, and body_solve
//     matches it (eqs. 8-9, 11-17) to where they bring its particles, as loose_solve does for loose particles. Bodies
//     that stand on each other, found once a step (stack_touch, stack_trees), then answer to their contacts with each
//     other at once (stack_pairs, stack_colliders, stack_solve). For bodies with joints jointed_solve notes what is
//     left to do, and joint_solve answers it for all bodies of a tree at once, joint_loop_solve for its loops;
//     gear_solve corrects the torques of gears, and gear_move moves the trees by them;
//   lets joints tear (joint_tear), and blows weaken what is driven (drive_hit);
//   ends with velocities and positions (mover_integrate, jointed_integrate), and where materials have restitution,
//     gives collisions the speeds at which they part (contact_restitution, collider_restitution, mover_restitution),
//     if there are any (restitution_due);
//     then looks whether anything has happened that lets go in the next substep (release_*).
//
// With Settings::sleepSpeed, assemblies that have been calm for long sleep from the end of a step on (sleep_mover,
// sleep_motor, sleep_island, sleep_update, sleep_state), until something that moves comes near them (sleep_wake_island,
// sleep_wake_assembly, in each substep).
//
// A step ends by placing particles where their bodies have them (particle_position); shared ones go to the mean of
// their goals, which is the joint (joint_position). Fluids then make and move
// points of foam (foam_*), which act on nothing. If there are emitters or drains, fluid particles then leave the
// pools (emitter_update, pool_order, fluid_emit) or go back to them (fluid_drain). If nothing drives fluids,
// fluid_energy and fluid_energy_limit check whether their energy has risen.
//
// Where pictures show them (World::shown), contact_force adds up what contacts give in each substep, and particle_age
// says how long each particle has been in the scene.
//
// Freezing (Settings::freeze) does the same for each assembly by itself: freeze_mover, freeze_update at the end of a
// step.
//
// The paper's solver does all of this particle by particle (PaperStage): predict, then contact_average (each particle
// moves by the average of its overlaps), then each body is matched to its particles (body_sum, body_rotation) and they
// go to their goals (shape_goals, joint_goals), once with STABILIZE and then `iterations` times, and finish.
#include "sim/solver/step.h"

#include <algorithm>

namespace knuckle {

namespace {

void moveFluids(const Stages& s, Recorder& recorder, uint32_t index)
{
    if (s.viscosity) s.viscosity->begin(recorder);
    s.fluids->substep(recorder, index);
    if (s.viscosity) s.viscosity->solve(recorder);
}

/// Light ropes under heavy loads need more of them: with two at few substeps their tension does not settle. How far a
/// rope slides on a collider is known after the second.
uint32_t iterationsOf(const Stages& s, const Settings& settings)
{
    constexpr uint32_t MORE = 4, SLIDING = 2;
    constexpr float HEAVY_LOAD = 4000.0f;
    if (!s.strands) return settings.iterations;
    const uint32_t least = s.strands->load() > HEAVY_LOAD ? MORE : s.strands->touchesColliders() ? SLIDING : 1;
    return std::max(settings.iterations, least);
}

void impulseSubstep(const Stages& s, const Settings& settings, Recorder& recorder, uint32_t index)
{
    const uint32_t iterations = iterationsOf(s, settings);
    if (s.forces) s.forces->find(recorder);
    if (s.drives) s.drives->catchAgain(recorder);
    if (s.releases) s.releases->noteBefore(recorder);
    s.bodies.predict(recorder);
    if (s.animations) s.animations->animate(recorder);
    if (s.drives) s.drives->begin(recorder);
    if (s.drives) s.drives->pull(recorder);
    if (s.motors) s.motors->begin(recorder);
    if (s.motors) s.motors->turn(recorder);
    if (s.gears) s.gears->begin(recorder);
    s.search.find(recorder);
    s.contacts.prepare(recorder);
    if (s.sleep) s.sleep->wake(recorder);
    if (s.stacks && index == 0) s.stacks->find(recorder);
    s.bodies.warmStart(recorder);
    if (s.fluids) moveFluids(s, recorder, index);
    if (s.forces) s.forces->actOnFluids(recorder);
    s.joints.factor(recorder);
    s.joints.solve(recorder, true);
    if (s.gears) s.gears->solve(recorder);
    for (uint32_t i = 0; i < iterations; ++i) {
        if (s.soft) s.soft->solve(recorder, i, iterations);
        if (s.strands) s.strands->solve(recorder, i == 0);
        s.contacts.solve(recorder);
        if (s.drives) s.drives->pull(recorder);
        if (s.motors) s.motors->turn(recorder);
        s.bodies.solve(recorder, i > 0);
        if (s.stacks) s.stacks->solve(recorder, i == 0);
        s.joints.factorAgain(recorder, iterations > 1 && i + 1 == iterations);
        s.joints.solve(recorder);
        if (s.gears) s.gears->solve(recorder);
    }
    if (s.stacks) s.stacks->keep(recorder);
    s.joints.tear(recorder);
    if (s.drives) s.drives->end(recorder);
    s.bodies.integrate(recorder);
    if (s.releases) s.releases->noteAfter(recorder);
    if (s.restitution) s.restitution->apply(recorder);
    if (s.releases) s.releases->watch(recorder);
    if (s.shown) s.shown->addForces(recorder, index == 0);
}

/// In a world without solid particles.
void fluidSubstep(const Stages& s, Recorder& recorder, uint32_t index)
{
    if (s.animations) s.animations->animate(recorder);
    s.search.count(recorder);
    moveFluids(s, recorder, index);
    if (s.forces) s.forces->actOnFluids(recorder);
}

void impulseStep(const Stages& s, const Settings& settings, Recorder& recorder)
{
    const bool fluidsOnly = s.layout.solidCount == 0;
    if (s.animations) s.animations->lookAhead(recorder);
    if (s.fluids) s.fluids->beginStep(recorder);
    for (uint32_t i = 0; i < settings.substeps; ++i)
        fluidsOnly ? fluidSubstep(s, recorder, i) : impulseSubstep(s, settings, recorder, i);
    s.bodies.placeParticles(recorder);
    s.joints.placeParticles(recorder);
    if (s.sleep) s.sleep->endStep(recorder);
    if (s.fluidWatch) s.fluidWatch->watch(recorder);
    // Before fluid comes and goes: slots are those of the step.
    if (s.foam) s.foam->endStep(recorder);
    if (s.forms) s.forms->endStep(recorder);
    if (s.shown) s.shown->endStep(recorder);
    if (s.emitters) s.emitters->endStep(recorder);
}

void paperStep(const Stages& s, const Settings& settings, Recorder& recorder)
{
    for (uint32_t i = 0; i < settings.substeps; ++i) {
        s.paper->predict(recorder);
        s.search.find(recorder);
        s.contacts.prepare(recorder);
        if (s.sleep) s.sleep->wake(recorder);
        s.paper->solve(recorder);
    }
    if (s.sleep) s.sleep->endStep(recorder);
    if (s.shown) s.shown->endStep(recorder);
}

}  // namespace

void recordStart(Stages& stages, Recorder& recorder)
{
    if (stages.fluids) stages.fluids->relax(recorder);
    if (stages.forms) stages.forms->endStep(recorder);
    if (stages.fluidWatch) stages.fluidWatch->begin(recorder);
}

void recordStep(const Stages& stages, const Settings& settings, Recorder& recorder)
{
    if (stages.paper) paperStep(stages, settings, recorder);
    else impulseStep(stages, settings, recorder);
}

}  // namespace knuckle
