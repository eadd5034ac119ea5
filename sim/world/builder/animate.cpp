#include <stdexcept>

#include "sim/world/builder/builder.h"

namespace knuckle {

uint32_t WorldBuilder::addClip(BodyClip clip)
{
    world_.clips.push_back(std::move(clip));
    return static_cast<uint32_t>(world_.clips.size() - 1);
}

void WorldBuilder::animate(Animation animation)
{
    if (objectOpen_) throw std::logic_error("animate: call endObject() first");
    const Object& object = world_.objects.at(animation.object);
    for (uint32_t b = object.bodyStart; b < object.bodyStart + object.bodyCount; ++b)
        world_.bodies[b].motion = Motion::Animated;
    world_.animations.push_back(std::move(animation));
}

void WorldBuilder::releaseBody(uint32_t body, float time)
{
    world_.bodies.at(body).releaseTime = time;
}

void WorldBuilder::poseAnimated()
{
    const float substep = world_.settings.timeStep / static_cast<float>(world_.settings.substeps);
    for (const Animation& animation : world_.animations) {
        const Object& object = world_.objects[animation.object];
        const std::vector<Pose> now = sampleAnimation(world_, animation, 0.0);
        const std::vector<Pose> next = sampleAnimation(world_, animation, substep);
        for (uint32_t k = object.bodyCount; k-- > 0;) {
            Body& body = world_.bodies[object.bodyStart + k];
            body.position = now[k].translation;
            body.rotation = now[k].rotation;
            for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
                Particle& particle = world_.particles[world_.links[l].particle];
                particle.position = now[k].apply(world_.links[l].restOffset);
                particle.velocity = (next[k].apply(world_.links[l].restOffset) - particle.position) / substep;
            }
        }
    }
}

}  // namespace knuckle
