#include "sim/solver/fluid/fluid_watch_stage.h"

#include <algorithm>
#include <array>
#include <limits>

namespace knuckle {

namespace {

/// Allowances for fluid whose lattice gives way, and for rounding: the kinetic energy of this speed [m/s], and this
/// share of the energy that fluid gains if all of it falls to its lowest particle.
constexpr float SPEED_FROM_NOTHING = 1.0f, SHARE_FROM_NOTHING = 0.1f;

/// An upper bound of the energy that fluids may gain [J]: from solids that fall to the fluids' lowest level or already
/// move, from surface tension, and from the allowances above.
float mostGain(const World& world)
{
    const Vector3f& gravity = world.settings.gravity;
    const size_t solids = world.solidCount();
    float floor = -std::numeric_limits<float>::infinity();  // gravity times depth
    for (size_t i = solids; i < world.particles.size(); ++i)
        floor = std::max(floor, gravity.dot(world.particles[i].position));
    double sum = 0.0;
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const Particle& p = world.particles[i];
        const float fall = std::max(floor - gravity.dot(p.position), 0.0f);
        const Material& material = world.materials[p.material];
        sum += i < solids ? p.mass * (fall + 0.5f * p.velocity.squaredNorm())
                          : p.mass * (SHARE_FROM_NOTHING * fall + 0.5f * SPEED_FROM_NOTHING * SPEED_FROM_NOTHING +
                                      cohesionPressure(material.surfaceTension, world.fluidSpacing) / material.density);
    }
    return static_cast<float>(sum);
}

}  // namespace

bool FluidWatchStage::isNeeded(const World& world)
{
    return world.fluidCount > 0 && !hasForces(world) && world.emitters.empty() && world.drains.empty() &&
           world.animations.empty() && world.colliderMotions.empty() && world.settings.vorticity == 0.0f;
}

void FluidWatchStage::upload(const StageSetup& setup)
{
    fluidCount_ = setup.world.fluidCount;
    fluidEnergySums = {"fluidEnergySums", groupsFor(fluidCount_)};
    const std::array<float, 2> limits{0.0f, mostGain(setup.world)};
    fluidEnergyLimits = {"fluidEnergyLimits", std::span<const float>(limits)};
}

void FluidWatchStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::State, fluidEnergyLimits);
    table.add(Lifetime::Scratch, fluidEnergySums);
}

void FluidWatchStage::sum(Recorder& recorder) const
{
    recorder.perElement(sum_, fluidCount_);
}

void FluidWatchStage::begin(Recorder& recorder) const
{
    sum(recorder);
    recorder.groups(begin_, 1);
}

void FluidWatchStage::allowAll()
{
    const std::array<float, 2> limits{std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
    fluidEnergyLimits.upload(std::span<const float>(limits));
}

void FluidWatchStage::watch(Recorder& recorder) const
{
    sum(recorder);
    recorder.groups(watch_, 1);
}

}  // namespace knuckle
