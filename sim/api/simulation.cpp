#include "sim/api/simulation.h"

#include <stdexcept>
#include <thread>
#include <utility>

#include "sim/gpu/device/thread_device.h"
#include "sim/solver/solver.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

/// Steps between checks of lists: after an overflow, at most these are repeated.
constexpr uint32_t STEPS_A_CHECK = 8;

}  // namespace

struct Simulation::Impl {
    Impl(World worldIn, const std::string& device)
        : world(std::move(worldIn)), gpu(deviceOfThread(device, FrameWork{stepWorkload(world), {}})),
          solver(*gpu, world)
    {
    }

    World world;
    std::shared_ptr<Gpu> gpu;
    Solver solver;
    uint64_t steps = 0;
    std::thread::id thread = std::this_thread::get_id();
};

Simulation::Simulation(World world, const std::string& device) : impl_(std::make_unique<Impl>(std::move(world), device))
{
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation::Impl& Simulation::here() const
{
    if (std::this_thread::get_id() != impl_->thread)
        throw std::logic_error("Simulation: called from another thread than the one that made it");
    return *impl_;
}

void Simulation::step(uint32_t count)
{
    Impl& impl = here();
    for (uint32_t k = 1; k <= count; ++k) {
        impl.solver.step();
        ++impl.steps;
        if (k == count || k % STEPS_A_CHECK == 0) impl.solver.checkCounters(impl.steps);
    }
}

double Simulation::time() const
{
    return static_cast<double>(impl_->steps) * static_cast<double>(impl_->world.settings.timeStep);
}

uint64_t Simulation::steps() const
{
    return impl_->steps;
}

const World& Simulation::world() const
{
    return impl_->world;
}

std::vector<Vector3f> Simulation::positions()
{
    return here().solver.readParticles().positions;
}

std::vector<Vector3f> Simulation::velocities()
{
    return here().solver.readParticles().velocities;
}

ParticleState Simulation::particles()
{
    return here().solver.readParticles();
}

std::vector<BodyState> Simulation::bodies()
{
    return here().solver.readBodies();
}

Measures Simulation::measure()
{
    return here().solver.measure();
}

uint64_t Simulation::hash()
{
    return here().solver.stateHash();
}

const std::string& Simulation::deviceName() const
{
    return impl_->gpu->device().name;
}

}  // namespace knuckle
