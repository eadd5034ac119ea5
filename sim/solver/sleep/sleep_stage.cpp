#include "sim/solver/sleep/sleep_stage.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/drive/motor_stage.h"

namespace knuckle {

namespace {

// Least number of calm steps before an assembly sleeps.
constexpr uint32_t CALM_STEPS = 30;
// Time for which an assembly has to be calm before it freezes [s].
constexpr float FREEZE_SECONDS = 1.0f;

/// Assemblies in which a joint or a rope lets go, and the first substep after that.
std::vector<gpu::uvec2> releasesOf(const World& world)
{
    std::vector<gpu::uvec2> out;
    const auto add = [&](uint32_t assembly, float time) {
        if (std::isfinite(time)) out.push_back({assembly, world.settings.substepAt(time)});
    };
    for (const Joint& joint : world.joints) add(world.bodies[joint.child].assembly, joint.strength.time);
    for (const Strand& strand : world.strands)
        for (const float time : {strand.startRelease, strand.endRelease})
            add(world.particles[strand.particles.front()].assembly, time);
    return out;
}

}  // namespace

SleepStage::SleepStage(const StageSetup& setup)
    : parameters_(setup.parameters), freezes_(setup.world.settings.freeze > 0.0f),
      meetsMoving_(!setup.world.colliderMotions.empty() && setup.layout.solidCount > 0),
      hasMotors_(MotorStage::isNeeded(setup.world)), letsGo_(!releasesOf(setup.world).empty())
{
}

void SleepStage::upload(const StageSetup& setup)
{
    const Settings& s = setup.world.settings;
    gpu::StepParameters& p = setup.parameters;
    p.sleepSpeed = s.sleepSpeed;
    // Positions within half the distance from a centre are within the whole distance of each other.
    p.freeze = 0.5f * s.freeze * setup.world.particleRadius;
    p.calmSteps = CALM_STEPS;
    if (freezes_) p.calmSteps = std::max(CALM_STEPS, static_cast<uint32_t>(std::ceil(FREEZE_SECONDS / s.timeStep)));
    const uint32_t count = setup.layout.assemblyCount;
    std::vector<gpu::uvec2> awake(count), next(count);
    for (uint32_t a = 0; a < count; ++a) {
        awake[a] = {0, a};
        next[a] = {p.calmSteps, a};
    }
    const std::vector<gpu::vec4> unturned(setup.layout.moverCount(), gpu::vec4{0, 0, 0, 1});
    assemblyCalm = {"assemblyCalm", std::span<const gpu::uvec2>(awake)};
    assemblyNext = {"assemblyNext", std::span<const gpu::uvec2>(next)};
    islandsWoken = {"islandsWoken", count};
    const std::vector<gpu::uvec2> releases = releasesOf(setup.world);
    sleepReleases = {"sleepReleases", std::span<const gpu::uvec2>(releases)};
    calmCentres = {"calmCentres", setup.layout.moverCount()};
    calmRotations = {"calmRotations", std::span<const gpu::vec4>(unturned)};
}

void SleepStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, sleepReleases);
    table.add(Lifetime::State, assemblyCalm, assemblyNext, islandsWoken, calmCentres, calmRotations);
}

void SleepStage::wake(Recorder& recorder) const
{
    recorder.decided(wakeIsland_, DISPATCH_PAIRS);
    if (meetsMoving_) recorder.decided(wakeByCollider_, DISPATCH_COLLIDER_PAIRS);
    recorder.perElement(wakeAssembly_, parameters_.assemblyCount);
    recorder.decided(wakeMovers_, DISPATCH_MOVERS);
}

void SleepStage::endStep(Recorder& recorder) const
{
    if (meetsMoving_) recorder.decided(besideCollider_, DISPATCH_COLLIDER_PAIRS);
    if (hasMotors_) recorder.perElement(motor_, parameters_.motorCount);
    if (letsGo_) recorder.perElement(release_, sleepReleases.size());
    if (freezes_) {
        recorder.perElement(freezeMover_, parameters_.moverCount);
        recorder.perElement(freezeUpdate_, parameters_.assemblyCount);
    } else {
        recorder.perElement(sleepMover_, parameters_.moverCount);
        recorder.decided(sleepIsland_, DISPATCH_PAIRS);
        recorder.perElement(sleepUpdate_, parameters_.assemblyCount);
    }
    recorder.perElement(rest_, parameters_.moverCount);
}

}  // namespace knuckle
