#include "app/export/points/particle_points.h"

namespace knuckle {

namespace {

/// Half of what it keeps from its like [m].
float radiusOf(const World& world, uint32_t particle)
{
    if (particle >= world.solidCount()) return 0.5f * world.fluidSpacing;
    return world.particleRadius * world.particles[particle].scale;
}

}  // namespace

ParticlePoints pointsOf(const ExportFrame& frame)
{
    const ParticleState& state = *frame.particles;
    ParticlePoints points;
    for (uint32_t i = 0; i < state.positions.size(); ++i) {
        if (state.inactive[i]) continue;
        const Particle& particle = frame.world.particles[i];
        points.ids.push_back(i);
        for (int axis = 0; axis < 3; ++axis) points.places.push_back(state.positions[i][axis]);
        for (int axis = 0; axis < 3; ++axis) points.velocities.push_back(state.velocities[i][axis]);
        points.bodies.push_back(static_cast<int32_t>(particle.body));  // NO_INDEX becomes -1
        points.materials.push_back(static_cast<int32_t>(particle.material));
        points.radii.push_back(radiusOf(frame.world, i));
        if (frame.densities == nullptr) continue;
        const uint32_t solids = frame.world.solidCount();
        points.densities.push_back(frame.world.materials[particle.material].density *
                                   (i < solids ? 1.0f : (*frame.densities)[i - solids]));
    }
    return points;
}

}  // namespace knuckle
