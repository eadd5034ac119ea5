#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

struct World;

/// A spring and a damper between where something is and where a clip has it.
struct DriveSpring {
    static constexpr float INFINITE = std::numeric_limits<float>::infinity();

    float frequency = 4.0f;     ///< At which what it moves swings about its target [Hz], 0 ... 20; 0: it does nothing.
    float dampingRatio = 1.0f;  ///< 0: it swings on, 1: it just does not swing; 0 ... 2.
    /// In place of frequency and ratio where either is above 0 [N m/rad], [N m s/rad]; of joints only.
    float stiffness = 0.0f, damping = 0.0f;
    float greatestTorque = INFINITE;  ///< [N m], > 0.
    float greatestForce = INFINITE;   ///< Of pins [N], > 0.

    bool isGiven() const { return stiffness > 0.0f || damping > 0.0f; }
    bool acts() const { return isGiven() || frequency > 0.0f; }
};

/// Holds a body where its clip has it in the world, in place and in direction.
struct Pin {
    uint32_t body = 0;  ///< Within the object.
    DriveSpring spring;
};

/// How strong all drives and pins of a puppet are from a time on: between keys on the way to the next.
struct StrengthKey {
    float time = 0.0f;    ///< Since the start [s], ascending.
    float value = 1.0f;   ///< Of stiffness and greatest torque, >= 0; damping goes with its root.
    bool smooth = false;  ///< Else straight to the next key.
};

/// What a blow does to a puppet: it takes strength from the body that it strikes and from those beside it.
struct HitReaction {
    float impulse = DriveSpring::INFINITE;  ///< Of a blow that takes all of it [N s], > 0; infinity: none does.
    float falloff = 0.5f;                   ///< Of what is taken, the part that the next body loses, 0 ... 1.
    float hold = 0.1f;                      ///< For how long after the last blow it stays away [s], >= 0.
    float recover = 0.5f;                   ///< For how long all of it then comes back [s], > 0.
};

/// When a puppet is let go by itself, and is limp.
struct KnockOut {
    float distance = DriveSpring::INFINITE;    ///< Of its first body from where its clip has that [m], > 0.
    float torqueTime = DriveSpring::INFINITE;  ///< For how long a joint may turn as hard as it may [s], > 0.
};

/// What is limp or driven comes to be animated again.
struct Catch {
    enum class Otherwise : uint32_t { Limp, Driven, Animated };

    float time = 0.0f;                      ///< When it begins [s].
    float blend = 0.8f;                     ///< For how long drives and pins grow from nothing [s], >= 0.
    float near = 0.1f;                      ///< Every body nearer to its clip than that: animated [m], > 0.
    float within = 3.0f;                    ///< For how long it is tried [s].
    Otherwise otherwise = Otherwise::Limp;  ///< What it is where that was not enough.
    bool here = true;                       ///< Its clips go on where it lies then, not where they would be.
    std::vector<float> releaseTimes = {};   ///< Per body: when it is let go again [s]; infinity: never.
    std::vector<float> limpTimes = {};      ///< Per body: when it is limp again [s].
};

/// An animated object whose joints are driven to its clips while it responds: between what is animated and what is
/// limp. It is driven as soon as its bodies respond (Body::releaseTime).
struct Puppet {
    uint32_t animation = 0;           ///< Index into World::animations.
    std::vector<DriveSpring> joints;  ///< Per body of the object: of the joint that it hangs on; the first has none.
    std::vector<float> limpTimes;     ///< Per body: when its joint and pin go limp [s]; infinity: never.
    std::vector<Pin> pins;
    std::vector<StrengthKey> strength;  ///< None: 1.
    HitReaction hit;
    KnockOut knockOut;
    std::optional<Catch> caught;
};

/// The part of validate() that is about puppets. @throws InputError, std::logic_error.
void validatePuppets(const World& world);

}  // namespace knuckle
