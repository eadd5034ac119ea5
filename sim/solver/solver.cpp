#include "sim/solver/solver.h"

#include <fmt/format.h>

#include <bit>
#include <optional>

#include "sim/solver/buffers.h"
#include "sim/solver/measure.h"
#include "sim/solver/step.h"
#include "sim/solver/fluid/upload_fluid.h"
#include "sim/solver/fluid/upload_pool.h"
#include "sim/solver/rope/upload_distances.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

Settings chosenFor(const Gpu& gpu, Settings settings)
{
    // Group reductions cost llvmpipe twelve times the plain loop; a GPU gains by them (docs/performance.md).
    if (settings.reduction == ReductionKind::Auto)
        settings.reduction = gpu.device().software ? ReductionKind::Thread : ReductionKind::Group;
    return settings;
}

std::vector<Vector3f> unpack(const std::vector<gpu::vec4>& values)
{
    std::vector<Vector3f> out;
    out.reserve(values.size());
    for (const gpu::vec4& v : values) out.emplace_back(v.x, v.y, v.z);
    return out;
}

}  // namespace

struct Solver::Impl {
    Impl(Gpu& gpuIn, const World& worldIn)
        : gpu(gpuIn), world(worldIn), settings(chosenFor(gpuIn, worldIn.settings)),
          buffers(uploadWorld(gpuIn, worldIn))
    {
        step.emplace(gpu, buffers, settings);
    }

    Gpu& gpu;
    World world;
    Settings settings;
    SolverBuffers buffers;
    std::optional<Step> step;
    bool settled = false;
    KernelTimer timer;
};

Solver::Solver(Gpu& gpu, const World& world) : impl_(std::make_unique<Impl>(gpu, world)) {}

Solver::~Solver() = default;

void Solver::step()
{
    if (!impl_->settled) impl_->step->settle(impl_->timer);
    impl_->settled = true;
    impl_->step->run(impl_->timer);
}

void Solver::checkCounters(uint64_t frame)
{
    impl_->gpu.checkErrors();
    impl_->timer.collect();
    gpu::Counters counters = impl_->buffers.counters.download()[0];
    if (counters.problems == 0) return;
    if (counters.problems & PROBLEM_NAN) {
        const Particle& particle = impl_->world.particles[counters.badParticle];
        const std::string owner =
            particle.body == NO_INDEX ? "no body" : fmt::format("body \"{}\"", impl_->world.bodies[particle.body].name);
        throw RunError(fmt::format("frame {}: particle {} of {} (material \"{}\") has no finite velocity any more; "
                                   "raise solver.substeps or lower the speeds and forces of the scene",
                                   frame, counters.badParticle, owner, impl_->world.materials[particle.material].name));
    }
    if (counters.problems & PROBLEM_COLLIDERS)
        throw RunError(fmt::format("frame {}: a particle touches {} static colliders at a time and {} are possible; "
                                   "merge colliders that overlap", frame, counters.wantedColliders, COLLIDER_SLOTS));
    if (counters.wantedNeighbours > impl_->buffers.parameters.fluidSlots) {
        impl_->buffers.parameters.fluidSlots = (counters.wantedNeighbours + 11) / 4 * 4;
        makeFluid(impl_->buffers, impl_->world, impl_->gpu);
    }
    // More contacts than there was room for: the lists grow, the next substep fills them anew.
    gpu::StepParameters& room = impl_->buffers.parameters;
    if (counters.wantedContacts > room.contactSlots) room.contactSlots = counters.wantedContacts + 4;
    if (counters.wantedPairs > room.pairCapacity) room.pairCapacity = counters.wantedPairs * 3 / 2;
    if (counters.wantedColliderPairs > room.colliderPairCapacity)
        room.colliderPairCapacity = counters.wantedColliderPairs * 3 / 2;
    impl_->buffers.resizeContacts(impl_->gpu);
    counters.problems = counters.wantedNeighbours = counters.wantedContacts = 0;
    counters.wantedPairs = counters.wantedColliderPairs = 0;
    counters.pairCount = counters.colliderPairCount = 0;
    counters.due = 1;
    impl_->buffers.counters.upload(std::span<const gpu::Counters>(&counters, 1));
    impl_->step.emplace(impl_->gpu, impl_->buffers, impl_->settings);
}

ParticleView Solver::view() const
{
    const SolverBuffers& b = impl_->buffers;
    ParticleView view;
    view.positions = b.positions.id();
    view.velocities = b.velocities.id();
    view.info = b.particleInfo.id();
    view.bodyCentres = b.moverCentres.id();
    view.bodyRotations = b.moverRotations.id();
    view.particleCount = b.parameters.particleCount + b.parameters.fluidCount;
    view.bodyCount = b.parameters.bodyCount;
    view.solidCount = b.parameters.particleCount;
    view.radius = impl_->world.particleRadius;
    view.fluidSpacing = impl_->world.fluidSpacing;
    return view;
}

ParticleState Solver::readParticles()
{
    const std::vector<gpu::vec4> positions = impl_->buffers.positions.download();
    ParticleState state{unpack(positions), unpack(impl_->buffers.velocities.download()), {}};
    for (const gpu::vec4& position : positions) state.parked.push_back(position.w != 0.0f);
    return state;
}

std::vector<BodyState> Solver::readBodies()
{
    const ParticleState particles = readParticles();
    const auto centres = impl_->buffers.moverCentres.download();
    const auto rotations = impl_->buffers.moverRotations.download();
    std::vector<BodyState> states;
    for (size_t b = 0; b < impl_->world.bodies.size(); ++b) {
        const Quaternionf rotation(rotations[b].w, rotations[b].x, rotations[b].y, rotations[b].z);
        const Vector3f centre(centres[b].x, centres[b].y, centres[b].z);
        states.push_back(bodyState(impl_->world, impl_->world.bodies[b], particles, centre, rotation));
    }
    return states;
}

Measures Solver::measure()
{
    const ParticleState particles = readParticles();
    Measures measures = measureState(impl_->world, particles, readBodies());
    measureDistances(measures, impl_->world, particles, tornDistances(impl_->buffers, impl_->world));
    measureFluids(measures, fluidDensities(impl_->buffers));
    const FluidFigures figures = fluidFigures(impl_->buffers);
    measures.fluidCount = figures.living;
    measures.fluidEmitted = figures.emitted;
    measures.fluidDrained = figures.drained;
    return measures;
}

uint64_t Solver::stateHash()
{
    uint64_t hash = 0xcbf29ce484222325ull;
    for (const auto* buffer : {&impl_->buffers.positions, &impl_->buffers.velocities})
        for (const gpu::vec4& v : buffer->download())
            for (float value : {v.x, v.y, v.z})
                for (uint32_t bits = std::bit_cast<uint32_t>(value), k = 0; k < 4; ++k)
                    hash = (hash ^ (bits >> (8 * k) & 0xffu)) * 0x100000001b3ull;
    return hash;
}

uint32_t Solver::searchCount()
{
    return impl_->buffers.counters.download()[0].searchCount;
}

std::vector<PassTime> Solver::passTimes()
{
    impl_->timer.collect();
    std::vector<PassTime> times;
    for (const auto& [name, total] : impl_->timer.totals()) times.push_back({name, total.milliseconds, total.count});
    return times;
}

void Solver::timePasses()
{
    impl_->timer.enable(impl_->gpu);
}

}  // namespace knuckle
