#pragma once

#include <string>
#include <vector>

#include "sim/base/no_index.h"
#include "sim/world/space/pose.h"

namespace knuckle {

struct World;

/// A motion of an object's bodies: keys at a fixed rate, with each body's turn from the rest pose. The places of bodies
/// follow from these turns, because their joints hold.
struct BodyClip {
    std::string name;
    float rate = 60.0f;                   ///< Keys a second, > 0.
    uint32_t bodyCount = 0;               ///< Of the object that it is for.
    std::vector<Vector3f> roots = {};     ///< Per key: place of Animation::pivot in the object's frame [m].
    std::vector<Quaternionf> turns = {};  ///< Per key and body: the body's turn against its parent's, for the first
                                          ///< body against the object's. Neighbours in time are on the same side of the
                                          ///< sphere.

    uint32_t keyCount() const { return static_cast<uint32_t>(roots.size()); }
    float duration() const { return static_cast<float>(keyCount() - 1) / rate; }  ///< [s]
};

/// When and how a clip is played.
struct ClipPlay {
    uint32_t clip = 0;     ///< Index into World::clips.
    float at = 0.0f;       ///< When it begins [s]: the first at 0, the others in this order.
    float start = 0.0f;    ///< Place in the clip where it begins [s]; below 0, without `loop`: waits at its start
                           ///< first.
    float speed = 1.0f;    ///< >= 0.
    float fade = 0.0f;     ///< How long the play before it goes on beneath it [s].
    bool loop = true;      ///< Starts again at its end, continuing in place and direction; otherwise stays at its end.
    bool inPlace = false;  ///< Without its root's way over the ground.
};

/// An object whose bodies move as clips say, until they are let go (Body::releaseTime).
struct Animation {
    uint32_t object = NO_INDEX;
    Pose pose;                    ///< From the object's rest pose to the world.
    Vector3f pivot{0, 0, 0};      ///< On the first body, in the rest pose [m].
    std::vector<ClipPlay> plays;  ///< At least one.
};

/// The joint by which a body of an animation hangs on another.
struct AnimatedLink {
    uint32_t parent = NO_INDEX;  ///< Index within the object; NO_INDEX for the first body, which its pivot moves.
    Vector3f anchor{0, 0, 0};    ///< The joint, or the pivot, in the rest pose [m].
};

/// Links of all bodies of an animation's object. @throws std::logic_error unless they form one tree with the first as
/// root.
std::vector<AnimatedLink> linksOf(const World& world, const Animation& animation);
/// @throws std::logic_error unless links form one tree with the first as root.
void requireTree(const std::vector<AnimatedLink>& links);

/// A motion over the ground: a turn about y, then a shift.
struct GroundMotion {
    float yaw = 0.0f;         ///< [rad]
    Vector3f shift{0, 0, 0};  ///< [m]; y is 0.
    Vector3f apply(const Vector3f& p) const;
    /// The point that it turns about; only valid if the yaw is not 0.
    Vector3f centre() const;
};

/// Places of an animation's clips: each continues where the one before ends, in place and direction.
struct PlayPlaces {
    std::vector<GroundMotion> starts;  ///< Per play, before Animation::pose.
    std::vector<GroundMotion> loops;   ///< Per play: motion over one round.
};
PlayPlaces placePlays(const World& world, const Animation& animation);

/// Motions of the bodies of an animation's object at a time [s], from the rest pose to the world. The GPU does the same
/// in shaders/sim/animation; a test compares both.
std::vector<Pose> sampleAnimation(const World& world, const Animation& animation,
                                  const std::vector<AnimatedLink>& links, double time);

/// In a built world: per body its mass centre and its turn from the rest pose.
std::vector<Pose> bodyPlaces(const World& world, const Animation& animation, double time);

/// Validates animations. @throws InputError, std::logic_error.
void validateAnimations(const World& world);

}  // namespace knuckle
