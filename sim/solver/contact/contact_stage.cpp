#include "sim/solver/contact/contact_stage.h"

#include <cmath>

#include "sim/world/matter/grain.h"

namespace knuckle {

ContactStage::ContactStage(const StageSetup& setup)
    : parameters_(setup.parameters), byImpulses_(setup.world.settings.solver == SolverKind::Impulse),
      hasSolids_(setup.layout.solidCount > 0), hasColliders_(hasSolids_ && !setup.world.colliders.empty())
{
}

void ContactStage::upload(const StageSetup& setup)
{
    setParameters(setup);
    std::vector<gpu::vec4> frictions;
    for (const Material& material : setup.world.materials) {
        const GrainFriction friction = grainFriction(material);
        frictions.push_back({friction.sticking, friction.sliding, 0, 0});
    }
    grainFrictions = {"grainFrictions", std::span<const gpu::vec4>(frictions)};
}

/// docs/decisions has the figures that decided these numbers.
void ContactStage::setParameters(const StageSetup& setup)
{
    const Settings& s = setup.world.settings;
    gpu::StepParameters& p = setup.parameters;
    p.correction = 0.06f;
    if (byImpulses_) p.maxCorrection = 0.25f * p.substepTime;
    // Per substep, the parts that an impulse, its difference from its mean, and the mean keep.
    const float iterations = static_cast<float>(s.iterations);
    p.warmStart = std::pow(0.985f, 1.0f / iterations);
    p.impulseDamping = 1.0f - std::pow(0.95f, 1.0f / iterations);
    p.meanRate = 1.0f - std::pow(0.9975f, 1.0f / iterations);
    p.massScaling = s.massScaling;
}

void ContactStage::makeLists()
{
    const size_t pairCount = parameters_.pairCapacity, colliderCount = parameters_.colliderPairCapacity;
    pairSides.resize("pairSides", pairCount);
    pairArms.resize("pairArms", 2 * pairCount);
    pairImpulses.resize("pairImpulses", 2 * pairCount, HALVES);
    pairMeans.resize("pairMeans", 2 * pairCount, HALVES);
    colliderSides.resize("colliderSides", colliderCount);
    colliderArms.resize("colliderArms", colliderCount);
    colliderImpulses.resize("colliderImpulses", 2 * colliderCount, HALVES);
    colliderMeans.resize("colliderMeans", 2 * colliderCount, HALVES);
}

void ContactStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, grainFrictions);
    table.add(Lifetime::State, pairSides, pairArms, pairImpulses, pairMeans, colliderSides, colliderArms,
              colliderImpulses, colliderMeans);
}

void ContactStage::prepare(Recorder& recorder) const
{
    recorder.decided(preparePairs_, DISPATCH_NEW_PAIRS);
    if (hasColliders_) recorder.decided(prepareColliders_, DISPATCH_NEW_COLLIDER_PAIRS);
}

void ContactStage::solve(Recorder& recorder) const
{
    recorder.decided(solvePairs_, DISPATCH_PAIRS);
    if (hasColliders_) recorder.decided(solveColliders_, DISPATCH_COLLIDER_PAIRS);
}

std::vector<ContactForce> ContactStage::forces(const SearchStage& search, const gpu::Counters& counters) const
{
    // An impulse displaces a mass within a substep.
    const float unit = 1.0f / (parameters_.substepTime * parameters_.substepTime);
    std::vector<ContactForce> all;
    const auto add = [&](const Buffer<gpu::uvec2>& pairBuffer, const Buffer<gpu::vec4>& impulseBuffer, uint32_t count,
                         uint32_t capacity, bool isCollider) {
        if (count == 0) return;
        const std::vector<gpu::uvec2> pairs = pairBuffer.download();
        const std::vector<gpu::vec4> impulses = impulseBuffer.download();
        for (size_t q = 0; q < std::min(count, capacity); ++q) {
            const auto [first, second] = pairs[counters.listParity * capacity + q];
            const gpu::vec4& p = impulses[counters.listParity * capacity + q];
            if (p.w <= 0.0f) continue;
            all.push_back({first, isCollider ? NO_INDEX : second, isCollider ? second : NO_INDEX,
                           unit * Vector3f(p.x, p.y, p.z), unit * p.w});
        }
    };
    add(search.pairs, pairImpulses, counters.pairCount, parameters_.pairCapacity, false);
    add(search.colliderPairs, colliderImpulses, counters.colliderPairCount, parameters_.colliderPairCapacity, true);
    return all;
}

}  // namespace knuckle
