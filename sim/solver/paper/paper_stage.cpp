#include "sim/solver/paper/paper_stage.h"

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

/// Per link of a shared particle: how far the particle is placed beyond the mean of its bodies' goals for the body's
/// match, in distances of goal and mean. At the mean itself its small mass would hardly move the body. Instead it acts
/// as one mass, the same for all its bodies and split over the shared particles of each, that moves them to the mean in
/// an iteration. One mass for all keeps momentum. In the GPU's order of links.
std::vector<float> linkGainsOf(const World& world, const Layout& layout)
{
    std::vector<float> sharedOfBody(world.bodies.size()), inverse(world.particles.size());
    for (uint32_t b = 0; b < world.bodies.size(); ++b)
        sharedOfBody[b] = static_cast<float>(world.bodies[b].linkCount - layout.ownLinkCounts[b]);
    const auto isShared = [&](const Link& link) { return world.particles[link.particle].bodyCount > 1; };
    for (uint32_t l : layout.linkOrder) {
        const Link& link = world.links[l];
        const bool responds = world.bodies[link.body].motion != Motion::Fixed;
        if (isShared(link) && responds)
            inverse[link.particle] += layout.worstInverseMasses[l] * sharedOfBody[link.body];
    }
    std::vector<float> gains;
    for (uint32_t l : layout.linkOrder) {
        const Link& link = world.links[l];
        const Particle& particle = world.particles[link.particle];
        const float all = inverse[link.particle];
        gains.push_back(0.0f);
        if (!isShared(link) || all <= 0.0f) continue;
        const bool fixed = world.bodies[particle.body].motion == Motion::Fixed;
        const float mass = (fixed ? 1.0f : static_cast<float>(particle.bodyCount)) / all;
        gains.back() = mass / link.mass - 1.0f;
    }
    return gains;
}

ReductionKind chosenReduction(const StageSetup& setup)
{
    // Group reductions cost llvmpipe twelve times the plain loop; a GPU gains from them (docs/decisions).
    const ReductionKind asked = setup.world.settings.reduction;
    if (asked != ReductionKind::Auto) return asked;
    return setup.gpu.device().software ? ReductionKind::Thread : ReductionKind::Group;
}

/// Every second partial sum of a block adds the next, then every fourth, and so on.
std::vector<PaperStage::ReductionStep> planReduction(const World& world, std::vector<uint32_t>& links)
{
    std::vector<PaperStage::ReductionStep> steps;
    for (uint32_t stride = 1;; stride *= 2) {
        const auto begin = static_cast<uint32_t>(links.size());
        for (const Body& body : world.bodies)
            for (uint32_t k = 0; k + stride < body.linkCount; k += 2 * stride) links.push_back(body.linkStart + k);
        const auto end = static_cast<uint32_t>(links.size());
        if (begin == end) return steps;
        steps.push_back({begin, end, stride});
    }
}

/// The numbers that the paper leaves open (docs/decisions has the figures that decided them).
void setPaperParameters(gpu::StepParameters& p)
{
    p.overRelaxation = 2.0f;
    p.maxCorrection = 50.0f * 9.81f * p.substepTime * p.substepTime;
    p.stabilization = 0.5f * p.substepTime;
    p.deepOverlap = 0.2f * p.diameter;
    p.deepRecovery = 0.75f * p.substepTime;
    p.jointCorrection = 4.0f * p.substepTime;
}

}  // namespace

PaperStage::PaperStage(const StageSetup& setup)
    : parameters_(setup.parameters), stabilization_(setup.world.settings.stabilization),
      iterations_(setup.world.settings.iterations), reduction_(chosenReduction(setup)),
      hasShared_(!setup.layout.sharedParticles.empty()), inSteps_(reduction_ == ReductionKind::Steps)
{
}

void PaperStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    setPaperParameters(setup.parameters);
    std::vector<gpu::vec4> speeds;
    for (const Particle& p : world.particles) speeds.push_back(pack(p.velocity, 0));
    const std::vector<float> gains = linkGainsOf(world, setup.layout);
    std::vector<uint32_t> reduced;
    reductionSteps = planReduction(world, reduced);
    const size_t count = world.particles.size(), bodies = world.bodies.size(), links = world.links.size();
    oldMoves = {"oldMoves", count};
    oldVelocities = {"oldVelocities", std::span<const gpu::vec4>(speeds)};
    predicted = {"predicted", count};
    moved = {"moved", count};
    bodyStarts = {"bodyStarts", 2 * bodies};
    bodyMatrices = {"bodyMatrices", 3 * bodies};
    bodyActing = {"bodyActing", bodies};
    linkTerms = {"linkTerms", 3 * links};
    linkPulls = {"linkPulls", links};
    linkGains = {"linkGains", std::span<const float>(gains)};
    reductionLinks = {"reductionLinks", std::span<const uint32_t>(reduced)};
}

void PaperStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, linkGains, reductionLinks);
    table.add(Lifetime::State, oldMoves, oldVelocities, bodyActing, linkPulls);
    table.add(Lifetime::Scratch, predicted, moved, bodyStarts, bodyMatrices, linkTerms);
}

void PaperStage::predict(Recorder& recorder) const
{
    recorder.perElement(predict_, parameters_.particleCount);
    recorder.perElement(bodyStart_, parameters_.bodyCount);
}

void PaperStage::solve(Recorder& recorder) const
{
    for (uint32_t i = 0; i < stabilization_; ++i) stabilize(recorder);
    for (uint32_t i = 0; i < iterations_; ++i) {
        recorder.perElement(contactAverage_, parameters_.particleCount);
        match(recorder);
        recorder.perElement(shapeGoals_, parameters_.particleCount);
        recorder.perElement(jointGoals_, parameters_.sharedCount);
    }
    recorder.perElement(finish_, parameters_.particleCount);
}

void PaperStage::stabilize(Recorder& recorder) const
{
    recorder.perElement(contactStabilize_, parameters_.particleCount);
    match(recorder);
    recorder.perElement(shapeStabilize_, parameters_.particleCount);
    recorder.perElement(jointStabilize_, parameters_.sharedCount);
    recorder.perElement(bodyStart_, parameters_.bodyCount);
}

void PaperStage::match(Recorder& recorder) const
{
    if (inSteps_) reduceInSteps(recorder);
    else if (reduction_ == ReductionKind::Group) recorder.groups(bodySumGroup_, parameters_.bodyCount);
    else recorder.perElement(bodySum_, parameters_.bodyCount);
    recorder.perElement(bodyRotation_, parameters_.bodyCount);
}

void PaperStage::reduceInSteps(Recorder& recorder) const
{
    reduce(recorder, linkCentreTerms_, linkCentreReduce_, bodyCollectCentres_);
    reduce(recorder, linkMatrixTerms_, linkMatrixReduce_, bodyCollectMatrices_);
}

void PaperStage::reduce(Recorder& recorder, const Kernel& terms, const Kernel& step, const Kernel& collect) const
{
    recorder.perElement(terms, parameters_.linkCount);
    for (const ReductionStep& s : reductionSteps) {
        glProgramUniform3ui(step.program(), 0, s.begin, s.end, s.stride);
        recorder.perElement(step, s.end - s.begin);
    }
    recorder.perElement(collect, parameters_.bodyCount);
}

}  // namespace knuckle
