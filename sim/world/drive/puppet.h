#pragma once

#include <limits>
#include <vector>

#include "sim/world/no_index.h"

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

/// An animated object whose joints are driven to its clips while it responds: between what is animated and what is
/// limp. It is driven as soon as its bodies respond (Body::releaseTime).
struct Puppet {
    uint32_t animation = 0;           ///< Index into World::animations.
    std::vector<DriveSpring> joints;  ///< Per body of the object: of the joint that it hangs on; the first has none.
    std::vector<float> limpTimes;     ///< Per body: when its joint and pin go limp [s]; infinity: never.
    std::vector<Pin> pins;
    std::vector<StrengthKey> strength;  ///< None: 1.
};

/// The part of validate() that is about puppets. @throws InputError, std::logic_error.
void validatePuppets(const World& world);

}  // namespace knuckle
