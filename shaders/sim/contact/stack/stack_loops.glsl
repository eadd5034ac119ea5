// The step of a stack: by elimination along its tree. Where there are loops, by conjugate gradients of which that is
// the preconditioner, so that they need no more rounds than loops have degrees of freedom.
#include "sim/contact/stack/stack_elimination.glsl"

// Rounds for each loop, and besides; no more than a driver lets a thread run through (DeviceLimits::loopRounds), at so
// many rounds of loops for each body.
#define LOOP_ROUNDS 6u
#define ROUND_LOOPS 32u
#define MOST_ROUNDS 60000u
// What a step may be wrong by: of its energy, and for each body [diameters].
#define LOOP_ERROR 1e-10
#define LOOP_ROUNDING 1e-6

/// What the search direction needs, loops included.
void addLoopForces(uvec2 range)
{
    for (uint k = range.x; k < range.y; ++k)
        storeForce(stackOrder[k], STACK_FORCE, loadForce(stackOrder[k], STACK_SEARCH_FORCE));
    for (uint k = range.x; k < range.y; ++k) {
        uint body = stackOrder[k];
        FOR_LOOPS(body, loop, partner) {
            vec3 arm = centreNow(body) - centreNow(partner);
            Motion other = shifted(loadMotion(partner, STACK_SEARCH), arm);
            Motion apart = add(loadMotion(body, STACK_SEARCH), scaled(other, -1.0));
            Force force = product(loadInertia(body, loopRecord(loop)), apart);
            addForce(body, STACK_FORCE, force);
            addForce(partner, STACK_FORCE, scaled(shifted(force, -arm), -1.0));
        }
    }
}

float sumOfProducts(uvec2 range, uint force, uint motion)
{
    float sum = 0.0;
    for (uint k = range.x; k < range.y; ++k)
        sum += product(loadForce(stackOrder[k], force), loadMotion(stackOrder[k], motion));
    return sum;
}

/// Goes on along the search direction, as far as that leads.
void advance(uvec2 range, float left)
{
    addLoopForces(range);
    float part = left / sumOfProducts(range, STACK_FORCE, STACK_SEARCH);
    for (uint k = range.x; k < range.y; ++k) {
        uint body = stackOrder[k];
        storeMotion(body, STACK_SOLUTION,
                    add(loadMotion(body, STACK_SOLUTION), scaled(loadMotion(body, STACK_SEARCH), part)));
        addForce(body, STACK_RESIDUAL, scaled(loadForce(body, STACK_FORCE), -part));
    }
}

/// Turns the search direction to what is left. @param kept of the old one.
void turnSearch(uvec2 range, float kept)
{
    for (uint k = range.x; k < range.y; ++k) {
        uint body = stackOrder[k];
        Motion search = loadStep(body);
        Force force = loadForce(body, STACK_RESIDUAL);
        if (kept > 0.0) {
            search = add(search, scaled(loadMotion(body, STACK_SEARCH), kept));
            force = add(force, scaled(loadForce(body, STACK_SEARCH_FORCE), kept));
        }
        storeMotion(body, STACK_SEARCH, search);
        storeForce(body, STACK_SEARCH_FORCE, force);
    }
}

/// Leaves the step in STACK_STEP.
void takeStep(uvec2 range, uint loops)
{
    uint rounds = min(LOOP_ROUNDS * (loops + 1u), MOST_ROUNDS / (ROUND_LOOPS * (range.y - range.x)));
    if (rounds == 0u) loops = 0u;
    gather(range, loops);
    for (uint k = range.x; k < range.y; ++k) eliminate(stackOrder[k]);
    float left = 0.0, least = 0.0;
    for (uint round = 0u; round <= rounds; ++round) {
        if (round > 0u) advance(range, left);
        answerAll(range, loops);
        if (loops == 0u) return;
        float now = sumOfProducts(range, STACK_RESIDUAL, STACK_STEP);
        if (round == 0u) {
            for (uint k = range.x; k < range.y; ++k) {
                storeMotion(stackOrder[k], STACK_SOLUTION, Motion(vec3(0), vec3(0)));
                least += moverMass(stackOrder[k]);
            }
            least = max(LOOP_ERROR * now, least * pow(LOOP_ROUNDING * sim.diameter, 2.0));
        }
        if (now <= least) break;
        turnSearch(range, round > 0u ? now / left : 0.0);
        left = now;
    }
    for (uint k = range.x; k < range.y; ++k)
        storeMotion(stackOrder[k], STACK_STEP, loadMotion(stackOrder[k], STACK_SOLUTION));
}
