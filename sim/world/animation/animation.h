#pragma once

#include <string>
#include <vector>

#include "sim/base/no_index.h"
#include "sim/world/space/pose.h"

namespace knuckle {

struct World;

/// A motion of an object's bodies: keys at a fixed rate, of how each is turned away from the rest pose. Where bodies
/// are follows from that, for their joints hold.
struct BodyClip {
    std::string name;
    float rate = 60.0f;                   ///< Keys a second, > 0.
    uint32_t bodyCount = 0;               ///< Of the object that it is for.
    std::vector<Vector3f> roots = {};     ///< Per key: where Animation::pivot is, in the object's frame [m].
    std::vector<Quaternionf> turns = {};  ///< Per key and body: a body's turn against its parent's, the first one's
                                          ///< against the object's. Neighbours in time are on one side of the sphere.

    uint32_t keyCount() const { return static_cast<uint32_t>(roots.size()); }
    float duration() const { return static_cast<float>(keyCount() - 1) / rate; }  ///< [s]
};

/// When and how a clip is played.
struct ClipPlay {
    uint32_t clip = 0;     ///< Index into World::clips.
    float at = 0.0f;       ///< When it begins [s]: the first at 0, the others in this order.
    float start = 0.0f;    ///< Where in the clip it begins [s]; below 0, without `loop`: it waits at its start first.
    float speed = 1.0f;    ///< >= 0.
    float fade = 0.0f;     ///< For how long what was played before goes on beneath it [s].
    bool loop = true;      ///< Begins anew where it ends, in place and in direction; else it stays at its end.
    bool inPlace = false;  ///< Without the way that its root goes over the ground.
};

/// An object whose bodies move as clips say, until they are let go (Body::releaseTime).
struct Animation {
    uint32_t object = NO_INDEX;
    Pose pose;                    ///< Of the object's rest pose in the world.
    Vector3f pivot{0, 0, 0};      ///< Of the first body, in the rest pose [m].
    std::vector<ClipPlay> plays;  ///< At least one.
};

/// What a body of an animation hangs on.
struct AnimatedLink {
    uint32_t parent = NO_INDEX;  ///< Index within the object; NO_INDEX of the first, which is moved by its pivot.
    Vector3f anchor{0, 0, 0};    ///< The joint, or the pivot, in the rest pose [m].
};

/// Of each body of an animation's object. @throws std::logic_error where they are not one tree of the first.
std::vector<AnimatedLink> linksOf(const World& world, const Animation& animation);
/// @throws std::logic_error unless links are one tree of the first.
void requireTree(const std::vector<AnimatedLink>& links);

/// A motion over the ground: a turn about y, then a shift.
struct GroundMotion {
    float yaw = 0.0f;         ///< [rad]
    Vector3f shift{0, 0, 0};  ///< [m]; y is 0.
    Vector3f apply(const Vector3f& p) const;
    /// The point that it turns about; only where the yaw is not 0.
    Vector3f centre() const;
};

/// Where the clips of an animation are put: each goes on where the one before leaves off, in place and in direction.
struct PlayPlaces {
    std::vector<GroundMotion> starts;  ///< Per play, before Animation::pose.
    std::vector<GroundMotion> loops;   ///< Per play: what one round of it adds.
};
PlayPlaces placePlays(const World& world, const Animation& animation);

/// Where the bodies of an animation's object are at a time [s]: of each its motion from the rest pose to the world.
/// What shaders/sim/animation does on the GPU, which a test holds it to.
std::vector<Pose> sampleAnimation(const World& world, const Animation& animation,
                                  const std::vector<AnimatedLink>& links, double time);

/// Of a world that is built: of each body its mass centre and its turn from the rest pose.
std::vector<Pose> bodyPlaces(const World& world, const Animation& animation, double time);

/// The part of validate() that is about animations. @throws InputError, std::logic_error.
void validateAnimations(const World& world);

}  // namespace knuckle
