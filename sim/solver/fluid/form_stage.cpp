#include "sim/solver/fluid/form_stage.h"

#include <algorithm>

namespace knuckle {

bool FormStage::isNeeded(const World& world)
{
    return std::any_of(world.particles.end() - world.fluidCount, world.particles.end(),
                       [&](const Particle& p) { return world.materials[p.material].look.drawn != DrawnAs::Particles; });
}

void FormStage::upload(const StageSetup& setup)
{
    fluidForms = {"fluidForms", setup.world.particles.size()};
}

void FormStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::State, fluidForms);
}

}  // namespace knuckle
