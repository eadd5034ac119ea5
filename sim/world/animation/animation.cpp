#include "sim/world/animation/animation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/base/angles.h"
#include "sim/world/animation/clip_time.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

/// A round of a clip that returns to its start and turns by less than this does not turn [rad].
constexpr float LEAST_YAW = 0.01f;

float yawOf(const Quaternionf& turn)
{
    return 2.0f * std::atan2(turn.y(), turn.w());
}

Quaternionf aboutY(float yaw)
{
    return Quaternionf(Eigen::AngleAxisf(yaw, Vector3f::UnitY()));
}

/// The motion that brings one place and direction to another.
GroundMotion motionBetween(const Pose& from, const Pose& to)
{
    GroundMotion motion;
    motion.yaw = std::remainder(yawOf(to.rotation) - yawOf(from.rotation), WHOLE_TURN);
    if (std::abs(motion.yaw) < LEAST_YAW) motion.yaw = 0.0f;
    motion.shift = to.translation - aboutY(motion.yaw) * from.translation;
    motion.shift.y() = 0.0f;
    return motion;
}

Pose moved(const GroundMotion& motion, const Pose& pose)
{
    return {motion.apply(pose.translation), aboutY(motion.yaw) * pose.rotation};
}

/// A clip's pivot and turn, before it is placed in the world.
Pose rootAt(const BodyClip& clip, const ClipPlay& play, const GroundMotion& round, double time)
{
    const ClipTime at = clipTime(clip, play, time);
    Pose root{sampleRoot(clip, at), sampleTurn(clip, at, 0)};
    if (play.inPlace) {
        root.translation.x() = clip.roots[0].x();
        root.translation.z() = clip.roots[0].z();
        return root;
    }
    for (uint32_t n = 0; n < at.rounds; ++n) root = moved(round, root);
    return root;
}

GroundMotion roundOf(const BodyClip& clip, const ClipPlay& play)
{
    const size_t last = clip.keyCount() - 1;
    if (!play.loop || play.inPlace || last == 0) return {};
    return motionBetween({clip.roots[0], clip.turns[0]}, {clip.roots[last], clip.turns[last * clip.bodyCount]});
}

/// The plays that are active at a time, and the weight of the later one.
struct Mix {
    size_t before = 0, now = 0;
    float part = 1.0f;
};

Mix mixAt(const std::vector<ClipPlay>& plays, double time)
{
    Mix mix;
    while (mix.now + 1 < plays.size() && plays[mix.now + 1].at <= time) ++mix.now;
    const ClipPlay& play = plays[mix.now];
    mix.before = mix.now;
    if (mix.now == 0 || time >= play.at + play.fade) return mix;
    const float way = static_cast<float>((time - play.at) / play.fade);
    mix.before = mix.now - 1;
    mix.part = way * way * (3.0f - 2.0f * way);
    return mix;
}

}  // namespace

Vector3f GroundMotion::apply(const Vector3f& p) const
{
    return aboutY(yaw) * p + shift;
}

Vector3f GroundMotion::centre() const
{
    // c = R c + s, that is (1 - R) c = s, in the plane of x and z.
    const float c = std::cos(yaw), s = std::sin(yaw);
    Eigen::Matrix2f left;
    left << 1 - c, -s, s, 1 - c;
    const Eigen::Vector2f centre = left.inverse() * Eigen::Vector2f(shift.x(), shift.z());
    return {centre.x(), 0, centre.y()};
}

std::vector<AnimatedLink> linksOf(const World& world, const Animation& animation)
{
    const Object& object = world.objects.at(animation.object);
    const uint32_t first = object.bodyStart;
    std::vector<AnimatedLink> links(object.bodyCount);
    links[0].anchor = animation.pivot;
    for (const Joint& joint : world.joints) {
        if (!object.has(joint.child) || !object.has(joint.parent)) continue;
        links[joint.child - first] = {joint.parent - first, world.bodies[joint.child].restCentre + joint.childSide.arm};
    }
    requireTree(links);
    return links;
}

void requireTree(const std::vector<AnimatedLink>& links)
{
    for (uint32_t b = 0; b < links.size(); ++b) {
        uint32_t above = b, steps = 0;
        while (links[above].parent != NO_INDEX && steps++ < links.size()) above = links[above].parent;
        if (above != 0) throw std::logic_error("animation: the bodies of its object are not one tree of the first");
    }
}

PlayPlaces placePlays(const World& world, const Animation& animation)
{
    PlayPlaces places;
    for (size_t i = 0; i < animation.plays.size(); ++i) {
        const ClipPlay& play = animation.plays[i];
        const BodyClip& clip = world.clips.at(play.clip);
        places.loops.push_back(roundOf(clip, play));
        places.starts.emplace_back();
        if (i == 0) continue;
        const ClipPlay& last = animation.plays[i - 1];
        const Pose old = rootAt(world.clips[last.clip], last, places.loops[i - 1], play.at);
        places.starts[i] = motionBetween(rootAt(clip, play, places.loops[i], play.at),
                                         moved(places.starts[i - 1], old));
    }
    return places;
}

std::vector<Pose> sampleAnimation(const World& world, const Animation& animation,
                                  const std::vector<AnimatedLink>& links, double time)
{
    const PlayPlaces places = placePlays(world, animation);
    const Mix mix = mixAt(animation.plays, time);
    const auto turnOf = [&](size_t p, uint32_t body) {
        const ClipPlay& play = animation.plays[p];
        const BodyClip& clip = world.clips[play.clip];
        const ClipTime at = clipTime(clip, play, time);
        if (body > 0) return sampleTurn(clip, at, body);
        return moved(places.starts[p], rootAt(clip, play, places.loops[p], time)).rotation;
    };
    const auto pivotOf = [&](size_t p) {
        const ClipPlay& play = animation.plays[p];
        return moved(places.starts[p], rootAt(world.clips[play.clip], play, places.loops[p], time)).translation;
    };
    const Vector3f pivot = pivotOf(mix.before) + mix.part * (pivotOf(mix.now) - pivotOf(mix.before));
    std::vector<Pose> poses;
    for (uint32_t b = 0; b < links.size(); ++b) {
        Pose pose;
        for (uint32_t k = b; k != NO_INDEX; k = links[k].parent) {
            const Quaternionf turn = mixed(turnOf(mix.before, k), turnOf(mix.now, k), mix.part);
            pose.translation = turn * (pose.translation - links[k].anchor);
            if (links[k].parent != NO_INDEX) pose.translation += links[k].anchor;
            pose.rotation = turn * pose.rotation;
        }
        poses.push_back(
            {animation.pose.apply(pose.translation + pivot), (animation.pose.rotation * pose.rotation).normalized()});
    }
    return poses;
}

std::vector<Pose> bodyPlaces(const World& world, const Animation& animation, double time)
{
    std::vector<Pose> places = sampleAnimation(world, animation, linksOf(world, animation), time);
    for (uint32_t b = 0; b < places.size(); ++b)
        places[b].translation = places[b].apply(world.bodies[objectOf(world, animation).bodyStart + b].restCentre);
    return places;
}

}  // namespace knuckle
