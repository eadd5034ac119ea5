#pragma once

#include <string>

#include "sim/world/builder/builder.h"

namespace knuckle {

/// The kind of a rope's end.
struct RopeEnd {
    enum class Kind : uint32_t {
        Free,
        Fixed,     ///< At its place in the world, for ever.
        Attached,  ///< At a particle, of a body or loose, which becomes the rope's last one.
    };
    Kind kind = Kind::Free;
    uint32_t particle = NO_INDEX;                                ///< Attached only.
    float releaseTime = std::numeric_limits<float>::infinity();  ///< When the rope lets go there [s], > 0.
};

/// A rope: a row of particles, at most a diameter apart, that bends freely unless bendCompliance is set.
struct RopeSpec {
    Vector3f from{0, 0, 0}, to{0, -1, 0};  ///< Its ends in the world [m]; ignored for attached ends.
    float length = 0.0f;                   ///< At rest [m]; 0: the distance between its ends. Longer ones sag.
    RopeEnd start, end;
    float compliance = 0.0f;  ///< Of the whole rope: it lengthens by this per newton of load [m/N], >= 0.
    float bendCompliance = std::numeric_limits<float>::infinity();  ///< Per particle [m/N], >= 0; infinite: limp.
    float tearForce = std::numeric_limits<float>::infinity();       ///< [N], > 0.
    uint32_t material = 0;                                          ///< It weighs density x diameter^2 x length.
    Vector3f velocity{0, 0, 0};                                     ///< [m/s]
    bool drawn = false;                                             ///< As a tube (World::drawn).
};

/// Adds a rope as an object. @returns the object's index.
/// @throws InputError for a length below the distance of its ends.
uint32_t addRope(WorldBuilder& builder, const std::string& name, const RopeSpec& spec);

/// The nodes of a chain of `count` links of `length` each [m] that hangs at rest between two points, with equal masses
/// at inner nodes: it sags along gravity, or is straight if the points are as far apart as it is long. @returns count +
/// 1 nodes.
std::vector<Vector3f> hangingChain(const Vector3f& from, const Vector3f& to, uint32_t count, float length,
                                   const Vector3f& gravity);

}  // namespace knuckle
