#include "sim/world/builder/motion_builder.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace knuckle {

uint32_t MotionBuilder::addClip(BodyClip clip)
{
    world_.clips.push_back(std::move(clip));
    return static_cast<uint32_t>(world_.clips.size() - 1);
}

void MotionBuilder::animate(Animation animation)
{
    if (objectOpen_) throw std::logic_error("animate: call endObject() first");
    const Object& object = world_.objects.at(animation.object);
    for (uint32_t b = object.bodyStart; b < object.bodyEnd(); ++b) world_.bodies[b].motion = Motion::Animated;
    poseAnimated(animation);
    world_.animations.push_back(std::move(animation));
}

void MotionBuilder::releaseBody(uint32_t body, float time)
{
    world_.bodies.at(body).releaseTime = time;
}

void MotionBuilder::letGo(uint32_t body, float time, bool driven)
{
    float* release = &world_.bodies.at(body).releaseTime;
    for (Puppet& puppet : world_.puppets) {
        const Object& object = objectOf(world_, puppet);
        if (!object.has(body)) continue;
        const uint32_t b = body - object.bodyStart;
        const bool again = puppet.caught && time > puppet.caught->time;
        if (again) release = &puppet.caught->releaseTimes[b];
        if (again) world_.bodies[body].watched = true;
        float& limp = again ? puppet.caught->limpTimes[b] : puppet.limpTimes[b];
        if (!driven) limp = std::min(limp, time);
    }
    *release = std::min(*release, time);
}

void MotionBuilder::addRelease(Release release)
{
    for (const uint32_t body : release.bodies) world_.bodies.at(body).watched = true;
    world_.releases.push_back(std::move(release));
}

std::vector<AnimatedLink> MotionBuilder::draftedLinks(const Animation& animation) const
{
    const Object& object = world_.objects[animation.object];
    std::vector<AnimatedLink> links(object.bodyCount);
    links[0].anchor = animation.pivot;
    for (const JointDraft& draft : joints_) {
        const uint32_t child = draft.joint.child, parent = draft.joint.parent;
        if (!object.has(child)) continue;
        AnimatedLink& link = links[child - object.bodyStart];
        link = {parent - object.bodyStart, {0, 0, 0}};
        float count = 0.0f;
        for (const uint32_t p : bodyParticles_[child]) {
            if (std::ranges::find(bodyParticles_[parent], p) == bodyParticles_[parent].end()) continue;
            link.anchor += world_.particles[p].restPosition;
            count += 1.0f;
        }
        if (count > 0.0f) link.anchor /= count;
    }
    requireTree(links);
    return links;
}

void MotionBuilder::poseAnimated(const Animation& animation)
{
    const float substep = world_.settings.timeStep / static_cast<float>(world_.settings.substeps);
    const Object& object = world_.objects[animation.object];
    const std::vector<AnimatedLink> links = draftedLinks(animation);
    const std::vector<Pose> now = sampleAnimation(world_, animation, links, 0.0);
    const std::vector<Pose> next = sampleAnimation(world_, animation, links, substep);
    for (uint32_t k = object.bodyCount; k-- > 0;) {
        const uint32_t b = object.bodyStart + k;
        world_.bodies[b].position = now[k].translation;  // moved to the body's centre by build()
        world_.bodies[b].rotation = now[k].rotation;
        for (const uint32_t p : bodyParticles_[b]) {
            Particle& particle = world_.particles[p];
            particle.position = now[k].apply(particle.restPosition);
            particle.velocity = (next[k].apply(particle.restPosition) - particle.position) / substep;
        }
    }
}

}  // namespace knuckle
