#include "sim/world/match/start_world.h"

#include "sim/world/animation/collider_motion.h"

namespace knuckle {

namespace {

void poseObject(World& world, const Animation& animation, double time)
{
    const float substep = world.settings.timeStep / static_cast<float>(world.settings.substeps);
    const std::vector<Pose> now = bodyPlaces(world, animation, time);
    const std::vector<Pose> next = bodyPlaces(world, animation, time + double{substep});
    const Object object = objectOf(world, animation);
    // Parents come last, so that what they share with what hangs on them is where they have it.
    for (uint32_t k = object.bodyCount; k-- > 0;) {
        Body& body = world.bodies[object.bodyStart + k];
        body.position = now[k].translation;
        body.rotation = now[k].rotation;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            Particle& particle = world.particles[world.links[l].particle];
            particle.position = now[k].apply(world.links[l].restOffset);
            particle.velocity = (next[k].apply(world.links[l].restOffset) - particle.position) / substep;
        }
    }
}

}  // namespace

World atTime(World world, double time)
{
    for (const Animation& animation : world.animations) poseObject(world, animation, time);
    world.colliders = collidersAt(world, time);
    return world;
}

}  // namespace knuckle
