#include "sim/solver/restitution/restitution_stage.h"

#include <algorithm>

#include "shared/contact_constants.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

// Solves, each a plain round and an eager one. Detection, the energy ledger and the shares leave room for seven rounds.
constexpr uint32_t SOLVES = 2;

}  // namespace

bool RestitutionStage::isNeeded(const World& world)
{
    return world.settings.solver == SolverKind::Impulse && world.solidCount() > 0 &&
           std::ranges::any_of(world.materials, [](const Material& material) { return material.restitution > 0.0f; });
}

RestitutionStage::RestitutionStage(const StageSetup& setup)
    : parameters_(setup.parameters), iterations_(setup.world.settings.iterations),
      hasColliders_(!setup.world.colliders.empty())
{
}

void RestitutionStage::upload(const StageSetup& setup)
{
    adapt(setup.parameters);
    moverRestitutionSplits = {"moverRestitutionSplits", setup.layout.moverCount()};
    moverRestitutionShares = {"moverRestitutionShares", setup.layout.moverCount()};
    lastCollision = {"lastCollision", 1};
    restitutionSizes = {"restitutionSizes", RESTITUTION_SIZES};
    moverSolvedVelocities = {"moverSolvedVelocities", setup.world.bodies.size() * 3 + setup.layout.moverCount()};
}

void RestitutionStage::adapt(gpu::StepParameters& p)
{
    // Twice what gravity gives in a substep, so that resting bodies do not bounce.
    p.restitutionThreshold = std::max(2.0f * vectorOf(p.gravity).norm() * p.substepTime, 0.02f);
}

void RestitutionStage::makeLists()
{
    pairRestitutions = {"pairRestitutions", 2 * size_t(parameters_.pairCapacity)};
    colliderRestitutions = {"colliderRestitutions", 2 * size_t(parameters_.colliderPairCapacity)};
    pairLedgers = {"pairLedgers", parameters_.pairCapacity};
    colliderLedgers = {"colliderLedgers", parameters_.colliderPairCapacity};
}

void RestitutionStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Scratch, pairRestitutions, colliderRestitutions, pairLedgers, colliderLedgers,
              moverSolvedVelocities, moverRestitutionSplits, moverRestitutionShares, restitutionSizes);
    table.add(Lifetime::State, lastCollision);
}

void RestitutionStage::iterate(Recorder& recorder, const Kernel& pairs, const Kernel& colliders,
                               const Kernel& movers) const
{
    recorder.decided(pairs, restitutionSizes, RESTITUTION_PAIRS_SIZE);
    if (hasColliders_) recorder.decided(colliders, restitutionSizes, RESTITUTION_COLLIDER_PAIRS_SIZE);
    recorder.decided(movers, restitutionSizes, RESTITUTION_MOVERS_SIZE);
}

void RestitutionStage::apply(Recorder& recorder) const
{
    recorder.decided(detectPairs_, DISPATCH_PAIRS);
    if (hasColliders_) recorder.decided(detectColliders_, DISPATCH_COLLIDER_PAIRS);
    recorder.perElement(countMovers_, parameters_.moverCount);
    recorder.groups(due_, 1);
    for (uint32_t i = 0; i < iterations_; ++i) {
        recorder.decided(takeBack_, restitutionSizes, RESTITUTION_PAIRS_SIZE);
        recorder.decided(reachMovers_, restitutionSizes, RESTITUTION_MOVERS_SIZE);
    }
    recorder.decided(beginMovers_, restitutionSizes, RESTITUTION_MOVERS_SIZE);
    for (uint32_t i = 0; i < SOLVES; ++i) {
        iterate(recorder, solvePairs_, solveColliders_, moveMovers_);
        iterate(recorder, solvePairsEagerly_, solveCollidersEagerly_, moveMovers_);
    }
    iterate(recorder, pairLedgers_, colliderLedgers_, moverShares_);
    iterate(recorder, sharePairs_, shareColliders_, moveMovers_);
}

}  // namespace knuckle
