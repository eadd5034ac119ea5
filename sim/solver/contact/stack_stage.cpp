#include "sim/solver/contact/stack_stage.h"

#include <algorithm>

#include "shared/stack_records.h"
#include "sim/solver/restitution/restitution_stage.h"

namespace knuckle {

namespace {

// Newton steps in the first iteration of a substep, and in each after it.
constexpr uint32_t STEPS = 6, STEPS_AGAIN = 3;

/// Threads of stack_trees: many wait longer for each other, few have no rounds left in a large world.
uint32_t treesGroup(size_t bodies)
{
    constexpr size_t LARGE_WORLD = 2048;
    constexpr uint32_t LARGE_GROUP = 1024;
    return bodies > LARGE_WORLD ? LARGE_GROUP : GROUP_SIZE;
}

}  // namespace

bool StackStage::isNeeded(const World& world, const Layout& layout)
{
    const auto mayStack = [&](uint32_t b) { return world.bodies[b].round.radius == 0.0f; };
    // What touches without weight is not pressed: as a stack it would answer to a blow at once, without restitution.
    if (world.settings.gravity.isZero() && RestitutionStage::isNeeded(world)) return false;
    return world.settings.solver == SolverKind::Impulse && world.settings.massScaling == 0.0f &&
           std::ranges::count_if(layout.freeBodies, mayStack) >= LEAST_STACK;
}

StackStage::StackStage(const StageSetup& setup)
    : parameters_(setup.parameters), hasColliders_(!setup.world.colliders.empty()),
      treesGroup_(treesGroup(setup.layout.freeBodies.size()))
{
}

void StackStage::upload(const StageSetup& setup)
{
    const size_t bodies = setup.layout.bodyCount;
    stackTouches = {"stackTouches", STACK_TOUCHES * bodies};
    stackRounds = {"stackRounds", bodies};
    stackMembers = {"stackMembers", bodies};
    stackParents = {"stackParents", setup.layout.moverCount()};
    stackOrder = {"stackOrder", bodies};
    stackRanges = {"stackRanges", bodies / LEAST_STACK};
    stackSizes = {"stackSizes", 2};
    stackBlocks = {"stackBlocks", STACK_TEXELS * bodies};
}

void StackStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Scratch, stackTouches, stackRounds, stackMembers, stackParents, stackOrder, stackRanges,
              stackSizes, stackBlocks);
}

void StackStage::find(Recorder& recorder) const
{
    recorder.perElement(touch_, parameters_.moverCount);
    recorder.groups(trees_, 1);
}

void StackStage::solve(Recorder& recorder, bool first) const
{
    const uint32_t steps = first ? STEPS : STEPS_AGAIN;
    for (uint32_t k = 0; k < steps; ++k) {
        const bool pull = first && k == 0, ends = k + 1 == steps;
        recorder.decided(pull ? pairsFirst_ : pairs_, stackSizes, STACK_BODIES_SIZE);
        if (hasColliders_) recorder.decided(pull ? collidersFirst_ : colliders_, stackSizes, STACK_BODIES_SIZE);
        recorder.decided(solve_, stackSizes, STACKS_SIZE);
        const Pass& begin = first ? moveFirst_ : moveAgain_;
        const Pass& on = first ? move_ : moveAgainOn_;
        const Pass& end = first ? moveEnd_ : moveAgainEnd_;
        recorder.decided(k == 0 ? begin : ends ? end : on, stackSizes, STACKS_SIZE);
    }
}

void StackStage::keep(Recorder& recorder) const
{
    recorder.decided(keepPairs_, stackSizes, STACK_BODIES_SIZE);
    if (hasColliders_) recorder.decided(keepColliders_, stackSizes, STACK_BODIES_SIZE);
}

}  // namespace knuckle
