#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/api/world.h"
#include "sim/solver/measure/state.h"

namespace knuckle {

/// A World on the device, and its steps. The same World, program and driver give the same bits.
///
/// Each thread with simulations has one OpenGL context for them, without a window; it is current on that thread while
/// any of them lives, so a program that uses OpenGL itself should give simulations a thread of their own. All calls
/// must come from the thread that made the simulation, else they throw std::logic_error. After a RunError its state is
/// not meaningful.
class Simulation {
public:
    /// Uploads the world, which WorldBuilder::build() or loadScene() made; compiles kernels, which takes seconds at
    /// first. @param device "auto" (a GPU, else the CPU), "gpu", "software" or a number of `knuckle info`; the first
    /// simulation of a thread chooses for all.
    /// @throws DeviceError without OpenGL 4.3 or if the world is too large for the device; InputError for another word;
    /// std::logic_error for another device than the thread's.
    explicit Simulation(World world, const std::string& device = "auto");
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Advances by `count` times Settings::timeStep, and waits until the device is done.
    /// @throws RunError for a state that is no longer finite or for lists without room, naming the particle or the
    /// number to raise; DeviceError for errors of the driver.
    void step(uint32_t count = 1);
    /// Since the start [s].
    double time() const;
    uint64_t steps() const;

    /// The world at the start; particles and bodies below are in its order.
    const World& world() const;
    /// Of all particles [m].
    std::vector<Vector3f> positions();
    /// Of all particles [m/s].
    std::vector<Vector3f> velocities();
    /// Both at once, and which fluid particles are active.
    ParticleState particles();
    /// Of all bodies: place of the mass centre, rotation, velocities.
    std::vector<BodyState> bodies();
    /// How well the state holds together: depths, gaps, energies.
    Measures measure();
    /// FNV-1a over the bits of all positions and velocities, as `knuckle render --hash` prints it.
    uint64_t hash();
    /// The device, as the driver names it.
    const std::string& deviceName() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace knuckle
