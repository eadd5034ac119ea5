#include "sim/api/simulation.h"

#include <utility>

#include "sim/solver/stepped_solver.h"

namespace knuckle {

struct Simulation::Impl {
    Impl(World worldIn, const std::string& device) : world(std::move(worldIn)), solver(world, device) {}

    World world;
    SteppedSolver solver;
};

Simulation::Simulation(World world, const std::string& device) : impl_(std::make_unique<Impl>(std::move(world), device))
{
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step(uint32_t count)
{
    impl_->solver.step(count);
}

double Simulation::time() const
{
    return impl_->solver.time();
}

uint64_t Simulation::steps() const
{
    return impl_->solver.steps();
}

const World& Simulation::world() const
{
    return impl_->world;
}

std::vector<Vector3f> Simulation::positions()
{
    return impl_->solver.here().readParticles().positions;
}

std::vector<Vector3f> Simulation::velocities()
{
    return impl_->solver.here().readParticles().velocities;
}

ParticleState Simulation::particles()
{
    return impl_->solver.here().readParticles();
}

std::vector<BodyState> Simulation::bodies()
{
    return impl_->solver.here().readBodies();
}

Measures Simulation::measure()
{
    return impl_->solver.here().measure();
}

uint64_t Simulation::hash()
{
    return impl_->solver.here().stateHash();
}

const std::string& Simulation::deviceName() const
{
    return impl_->solver.gpu().device().name;
}

}  // namespace knuckle
