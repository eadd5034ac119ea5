#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

struct World;

/// A spring and a damper between something and its clip.
struct DriveSpring {
    static constexpr float INFINITE = std::numeric_limits<float>::infinity();

    float frequency = 4.0f;     ///< Of swings about the target [Hz], 0 ... 20; 0: no effect.
    float dampingRatio = 1.0f;  ///< 0: it keeps swinging, 1: it just does not swing; 0 ... 2.
    /// Replace frequency and ratio if either is above 0 [N m/rad], [N m s/rad]; of joints only.
    float stiffness = 0.0f, damping = 0.0f;
    float greatestTorque = INFINITE;  ///< [N m], > 0.
    float greatestForce = INFINITE;   ///< Of pins [N], > 0.

    bool isGiven() const { return stiffness > 0.0f || damping > 0.0f; }
    bool acts() const { return isGiven() || frequency > 0.0f; }
};

/// Holds a body at its clip's place and direction in the world.
struct Pin {
    uint32_t body = 0;  ///< Within the object.
    DriveSpring spring;
};

/// Strength of all drives and pins of a puppet from a time on; changes between keys.
struct StrengthKey {
    float time = 0.0f;    ///< Since the start [s], ascending.
    float value = 1.0f;   ///< Factor of stiffness and greatest torque, >= 0; damping gets its root.
    bool smooth = false;  ///< Otherwise straight to the next key.
};

/// Effect of a blow on a puppet: it reduces the strength of the body that it hits and of its neighbours.
struct HitReaction {
    float impulse = DriveSpring::INFINITE;  ///< Of a blow that takes all strength [N s], > 0; infinity: none does.
    float falloff = 0.5f;                   ///< The part of the loss that the next body gets, 0 ... 1.
    float hold = 0.1f;                      ///< How long strength stays away after the last blow [s], >= 0.
    float recover = 0.5f;                   ///< How long all of it then takes to come back [s], > 0.
};

/// When a puppet lets go by itself and goes limp.
struct KnockOut {
    float distance = DriveSpring::INFINITE;    ///< Of its first body from its clip [m], > 0.
    float torqueTime = DriveSpring::INFINITE;  ///< How long a joint may stay at its greatest torque [s], > 0.
};

/// How limp or driven bodies become animated again.
struct Catch {
    enum class Otherwise : uint32_t { Limp, Driven, Animated };

    float time = 0.0f;                      ///< When it begins [s].
    float blend = 0.8f;                     ///< How long drives and pins take to grow from nothing [s], >= 0.
    float near = 0.1f;                      ///< When every body is nearer to its clip than this, all are animated [m],
                                            ///< > 0.
    float within = 3.0f;                    ///< For how long this is tried [s].
    Otherwise otherwise = Otherwise::Limp;  ///< What happens if they do not get that near.
    bool here = true;                       ///< Its clips continue where it lies then, not where they would be.
    std::vector<float> releaseTimes = {};   ///< Per body: when it is let go again [s]; infinity: never.
    std::vector<float> limpTimes = {};      ///< Per body: when it is limp again [s].
};

/// An animated object whose joints are driven to its clips while it responds: between animated and limp. Driving starts
/// as soon as its bodies respond (Body::releaseTime).
struct Puppet {
    uint32_t animation = 0;           ///< Index into World::animations.
    std::vector<DriveSpring> joints;  ///< Per body of the object: of the joint that it hangs on; unused for the first.
    std::vector<float> limpTimes;     ///< Per body: when its joint and pin go limp [s]; infinity: never.
    std::vector<Pin> pins;
    std::vector<StrengthKey> strength;  ///< Empty: 1.
    HitReaction hit;
    KnockOut knockOut;
    std::optional<Catch> caught;
};

/// Validates puppets. @throws InputError, std::logic_error.
void validatePuppets(const World& world);

}  // namespace knuckle
