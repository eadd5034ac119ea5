#include "sim/solver/stepped_solver.h"

#include <atomic>
#include <stdexcept>

#include "sim/solver/workload.h"

namespace knuckle {

namespace {

/// Steps between checks of lists: after an overflow, at most these are repeated.
constexpr uint32_t STEPS_A_CHECK = 8;

/// The context of this thread: two would take it from each other.
struct ThreadDevice {
    std::weak_ptr<Gpu> gpu;
    std::string name;
};

/// Of this thread alone: a std::thread::id is given again when its thread has ended.
uint64_t threadNumber()
{
    static std::atomic<uint64_t> last{0};
    thread_local const uint64_t number = ++last;
    return number;
}

std::shared_ptr<Gpu> deviceOfThread(const std::string& name, const World& world)
{
    thread_local ThreadDevice device;
    if (auto gpu = device.gpu.lock()) {
        if (name != device.name)
            throw std::logic_error("Simulation: this thread computes on \"" + device.name + "\" already, not on \"" +
                                   name + "\"");
        return gpu;
    }
    auto gpu = std::make_shared<Gpu>(DeviceChoice::parse(name), std::string{}, FrameWork{stepWorkload(world), {}});
    device = {gpu, name};
    return gpu;
}

}  // namespace

SteppedSolver::SteppedSolver(const World& world, const std::string& device)
    : world_(world), gpu_(deviceOfThread(device, world)), solver_(*gpu_, world), thread_(threadNumber())
{
}

Solver& SteppedSolver::here()
{
    if (threadNumber() != thread_)
        throw std::logic_error("Simulation: called from another thread than the one that made it");
    return solver_;
}

void SteppedSolver::step(uint32_t count)
{
    Solver& solver = here();
    for (uint32_t k = 1; k <= count; ++k) {
        solver.step();
        ++steps_;
        if (k == count || k % STEPS_A_CHECK == 0) solver.checkCounters(steps_);
    }
}

double SteppedSolver::time() const
{
    return static_cast<double>(steps_) * static_cast<double>(world_.settings.timeStep);
}

void SteppedSolver::load(const SolverState& state, uint64_t steps)
{
    here().loadState(state);
    steps_ = steps;
}

}  // namespace knuckle
