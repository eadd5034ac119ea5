#include "sim/solver/solver.h"

#include <fmt/format.h>

#include "sim/base/errors.h"
#include "sim/solver/carry/carry_over.h"
#include "sim/solver/measure/measure.h"
#include "sim/solver/stages_view.h"
#include "sim/solver/state_copy.h"
#include "sim/solver/step.h"

namespace knuckle {

namespace {

/// Number of steps between copies of the state: a copy takes time, and after an overflow all steps since it are
/// repeated.
constexpr uint32_t STEPS_KEPT = 16;
/// Problems that lists with too little room report.
constexpr uint32_t OVERFLOWS = PROBLEM_CANDIDATES | PROBLEM_PAIRS | PROBLEM_FLUID;

}  // namespace

struct Solver::Impl {
    Impl(Gpu& gpuIn, const World& worldIn, const std::optional<ListRoom>& room)
        : gpu(gpuIn), world(worldIn), stages(gpuIn, world, {}, room)
    {
    }

    Gpu& gpu;
    const World& world;
    Stages stages;
    bool loaded = false, started = false;
    KernelTimer timer;

    void load()
    {
        if (!loaded) stages.load();
        loaded = true;
    }

    void record()
    {
        load();
        Recorder recorder = stages.recorder(timer);
        if (!started) recordStart(stages, recorder);
        started = true;
        recordStep(stages, world.settings, recorder);
    }

    /// Steps that overflowed are taken again from here.
    struct Kept {
        StateCopy state;
        bool started = false;
        uint32_t steps = 0;   ///< Since the copy.
        bool checked = true;  ///< Whether nothing has overflowed up to now.
    } kept;

    void keep()
    {
        kept.state.take(stages.table());
        kept.started = started;
        kept.steps = 0;
    }

    /// Repeats every step since the copy, with the room that lists lacked. Contents of lists that are state are kept.
    void takeAgain(const gpu::Counters& counters)
    {
        const uint32_t steps = kept.steps;
        kept.state.restore(stages.table());
        started = kept.started;
        stages.grow(counters);
        keep();
        for (; kept.steps < steps; ++kept.steps) record();
    }
};

Solver::Solver(Gpu& gpu, const World& world, const std::optional<ListRoom>& room, Loading loading)
    : impl_(std::make_unique<Impl>(gpu, world, room))
{
    if (loading == Loading::Now) prepare();
}

Solver::~Solver() = default;

void Solver::prepare()
{
    impl_->load();
}

void Solver::step()
{
    Impl::Kept& kept = impl_->kept;
    if (kept.state.empty() || (kept.checked && kept.steps >= STEPS_KEPT)) impl_->keep();
    impl_->record();
    ++kept.steps;
    kept.checked = false;
}

void Solver::checkCounters(uint64_t frame)
{
    impl_->gpu.checkErrors();
    impl_->timer.collect();
    gpu::Counters counters = impl_->stages.counters.download()[0];
    while (counters.problems & OVERFLOWS) {
        impl_->takeAgain(counters);
        counters = impl_->stages.counters.download()[0];
    }
    impl_->kept.checked = true;
    if (counters.problems & PROBLEM_FLUID_ENERGY)
        throw RunError(fmt::format("frame {}: fluids have gained energy that nothing gave them; give them more room at "
                                   "the start, lower their speeds, or raise solver.substeps",
                                   frame));
    if (counters.problems & PROBLEM_NAN) {
        const Particle& particle = impl_->world.particles[counters.badParticle];
        const std::string owner = particle.body == NO_INDEX
                                      ? "no body"
                                      : fmt::format("body \"{}\"", impl_->world.bodies[particle.body].name);
        throw RunError(fmt::format("frame {}: particle {} of {} (material \"{}\") has no finite velocity any more; "
                                   "raise solver.substeps or lower the speeds and forces of the scene",
                                   frame, counters.badParticle, owner, impl_->world.materials[particle.material].name));
    }
}

ParticleView Solver::view() const
{
    return viewOf(impl_->stages, impl_->world);
}

ViewState Solver::readView()
{
    return readViewOf(impl_->stages, impl_->world);
}

ParticleState Solver::readParticles()
{
    const Stages& s = impl_->stages;
    return particleState({.positions = s.particles.positions.download(),
                          .velocities = s.particles.velocities.download(),
                          .torn = s.joints.tornParticles(impl_->world)});
}

std::vector<BodyState> Solver::readBodies()
{
    return bodyStates(impl_->world, readView());
}

std::vector<Collider> Solver::readColliders()
{
    std::vector<Collider> colliders = impl_->world.colliders;
    const std::vector<gpu::vec4> places = impl_->stages.colliders.colliderPlaces.download();
    for (size_t c = 0; c < colliders.size(); ++c) {
        const gpu::vec4 &p = places[2 * c], &q = places[2 * c + 1];
        colliders[c].position = {p.x, p.y, p.z};
        colliders[c].orientation = Quaternionf(q.w, q.x, q.y, q.z);
    }
    return colliders;
}

Measures Solver::measure()
{
    const ParticleState particles = readParticles();
    Measures measures = measureState(impl_->world, readColliders(), particles, readBodies());
    const Stages& s = impl_->stages;
    measures.fluidCount = s.parameters.fluidCount;
    if (s.strands) s.strands->measure(measures, impl_->world, particles);
    if (s.fluids) measureFluids(measures, s.fluids->densities());
    if (s.emitters) s.emitters->measure(measures);
    if (s.drives) s.drives->measure(measures);
    return measures;
}

std::vector<float> Solver::fluidDensities()
{
    std::vector<float> densities(impl_->world.fluidCount, 1.0f);
    if (!impl_->stages.fluids) return densities;
    for (const auto& [particle, density] : impl_->stages.fluids->densities())
        densities[particle - impl_->world.solidCount()] = density;
    return densities;
}

uint64_t Solver::stateHash()
{
    impl_->stages.loadHash();
    return impl_->stages.stateHash.hash(impl_->timer);
}

SolverState Solver::saveState() const
{
    SolverState state{impl_->started, impl_->stages.save()};
    if (impl_->stages.motors) state.motors = impl_->stages.motors->motors.download();
    return state;
}

void Solver::loadState(const SolverState& state)
{
    impl_->stages.load(state.stages);
    if (!state.motors.empty()) impl_->stages.motors->motors.upload(state.motors);
    impl_->started = state.started;
    impl_->kept = {};
}

void Solver::carryOver(const Solver& other, const Counterparts& same, uint64_t steps)
{
    Stages &from = other.impl_->stages, &to = impl_->stages;
    gpu::Counters wanted{};
    wanted.wantedCandidates = from.parameters.candidateCapacity;
    wanted.wantedPairs = from.parameters.pairCapacity;
    wanted.wantedColliderPairs = from.parameters.colliderPairCapacity;
    to.grow(wanted);
    const auto substep = static_cast<uint32_t>(steps * impl_->world.settings.substeps);
    loadState({true, carriedOver({other.impl_->world, from}, {impl_->world, to}, same, substep)});
    impl_->load();
    Recorder recorder = to.recorder(impl_->timer);
    if (to.fluidWatch) to.fluidWatch->begin(recorder);
}

void Solver::edit(const std::function<void(StateEdit&)>& change)
{
    SolverState state = saveState();
    StateEdit edit(impl_->world, impl_->stages.layout, state.stages);
    change(edit);
    edit.commit();
    loadState(state);
    if (impl_->stages.fluidWatch) impl_->stages.fluidWatch->allowAll();
}

void Solver::surround(const Surroundings& surroundings)
{
    impl_->stages.surround(surroundings);
    edit([](StateEdit& edit) { edit.wakeAll(); });
}

bool Solver::drive(uint32_t joint, const TurnDrive& drive)
{
    Stages& s = impl_->stages;
    // Steps that are taken again would be driven otherwise.
    impl_->kept = {};
    return s.motors && s.motors->set(s.layout, joint, drive);
}

std::vector<ContactForce> Solver::contactForces()
{
    if (impl_->world.settings.solver == SolverKind::Paper)
        throw std::logic_error("the solver `paper` moves particles and has no forces of contacts");
    return impl_->stages.contacts.forces(impl_->stages.search, impl_->stages.counters.download()[0]);
}

uint32_t Solver::searchCount()
{
    return impl_->stages.counters.download()[0].searchCount;
}

uint64_t Solver::bufferBytes()
{
    const BufferTable table = impl_->stages.table();
    uint64_t sum = 0;
    for (const auto& [name, entry] : table.entries()) sum += entry.buffer->bytes();
    return sum;
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

void Solver::noteReleases()
{
    if (impl_->stages.releases) impl_->stages.releases->startNotes();
}

std::vector<LetGo> Solver::letGo()
{
    const Stages& s = impl_->stages;
    if (!s.releases) return {};
    return s.releases->letGo(s.bodies.bodyReleases.download(), s.counters.download()[0].substep);
}

}  // namespace knuckle
