#include "sim/solver/restitution/restitution_stage.h"

#include <algorithm>

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
    moverSolvedVelocities = {"moverSolvedVelocities", setup.world.bodies.size() * 3 + setup.layout.moverCount()};
}

void RestitutionStage::adapt(gpu::StepParameters& p)
{
    // Twice what gravity gives in a substep, so that resting bodies do not bounce.
    p.restitutionThreshold = std::max(2.0f * vectorOf(p.gravity).norm() * p.substepTime, 0.02f);
}

void RestitutionStage::makeLists(const Gpu&)
{
    pairRestitutions = {"pairRestitutions", 2 * size_t(parameters_.pairCapacity)};
    colliderRestitutions = {"colliderRestitutions", 2 * size_t(parameters_.colliderPairCapacity)};
    pairLedgers = {"pairLedgers", parameters_.pairCapacity};
    colliderLedgers = {"colliderLedgers", parameters_.colliderPairCapacity};
}

void RestitutionStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Scratch, pairRestitutions, colliderRestitutions, pairLedgers, colliderLedgers,
              moverSolvedVelocities, moverRestitutionSplits, moverRestitutionShares);
}

void RestitutionStage::iterate(Recorder& recorder, const Kernel& pairs, const Kernel& colliders,
                               const Kernel& movers) const
{
    recorder.decided(pairs, DISPATCH_PAIRS);
    if (hasColliders_) recorder.decided(colliders, DISPATCH_COLLIDER_PAIRS);
    recorder.perElement(movers, parameters_.moverCount);
}

void RestitutionStage::apply(Recorder& recorder) const
{
    iterate(recorder, detectPairs_, detectColliders_, countMovers_);
    for (uint32_t i = 0; i < iterations_; ++i) {
        recorder.decided(takeBack_, DISPATCH_PAIRS);
        recorder.perElement(reachMovers_, parameters_.moverCount);
    }
    recorder.perElement(beginMovers_, parameters_.moverCount);
    for (uint32_t i = 0; i < SOLVES; ++i) {
        iterate(recorder, solvePairs_, solveColliders_, moveMovers_);
        iterate(recorder, solvePairsEagerly_, solveCollidersEagerly_, moveMovers_);
    }
    iterate(recorder, pairLedgers_, colliderLedgers_, moverShares_);
    iterate(recorder, sharePairs_, shareColliders_, moveMovers_);
}

}  // namespace knuckle
