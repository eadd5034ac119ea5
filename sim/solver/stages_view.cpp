#include "sim/solver/stages_view.h"

namespace knuckle {

ParticleView viewOf(const Stages& s, const World& world)
{
    ParticleView view;
    view.positions = s.particles.positions.id();
    view.velocities = s.particles.velocities.id();
    view.bodyCentres = s.bodies.moverCentres.id();
    view.bodyRotations = s.bodies.moverRotations.id();
    view.colliderPlaces = s.colliders.colliderPlaces.id();
    view.colliderCount = s.parameters.colliderCount;
    view.particleCount = s.parameters.particleCount + s.parameters.fluidCount;
    view.bodyCount = s.parameters.bodyCount;
    view.solidCount = s.parameters.particleCount;
    view.radius = world.particleRadius;
    view.fluidSpacing = world.fluidSpacing;
    if (s.foam) view.foamPlaces = s.foam->foamPlaces.id();
    view.foamCount = s.parameters.foamCapacity;
    if (s.forms) view.fluidForms = s.forms->fluidForms.id();
    if (s.fluids) s.fluids->show(view);
    if (world.shown.ages) view.ages = s.shown->particleAges.id();
    if (world.shown.contactForces) view.contactForces = s.shown->contactForces.id();
    if (!s.strands || !canTear(world)) return view;
    view.distanceStates = s.strands->distanceStates.id();
    view.distanceCount = static_cast<uint32_t>(s.strands->distanceStates.size());
    return view;
}

ViewState readViewOf(const Stages& s, const World& world)
{
    ViewState view{s.particles.positions.download(),      s.particles.velocities.download(),
                   s.bodies.moverCentres.download(),      s.bodies.moverRotations.download(),
                   s.colliders.colliderPlaces.download(), s.joints.tornParticles(world)};
    // Movers that are no bodies come after them.
    view.bodyCentres.resize(world.bodies.size());
    view.bodyRotations.resize(world.bodies.size());
    view.colliderPlaces.resize(2 * world.colliders.size());
    if (s.foam) view.foamPlaces = s.foam->foamPlaces.download();
    if (s.forms) view.fluidForms = s.forms->fluidForms.download();
    if (s.shown) view.ages = s.shown->particleAges.download();
    if (s.shown) view.contactForces = s.shown->contactForces.download();
    if (!s.strands || !canTear(world)) return view;
    for (const gpu::vec4& state : s.strands->distanceStates.download()) view.tornDistances.push_back(state.z != 0.0f);
    return view;
}

}  // namespace knuckle
