#pragma once

#include <vector>

#include "sim/world/builder/builder.h"

namespace knuckle::test {

/// Two bodies of a world and their joint.
struct Joining {
    uint32_t a = 0, b = 0;
    JointType type = JointType::Ball;
};

/// Bodies of 3x2x3 particles along a curve in space, and the joints between them, each halfway between its two bodies,
/// hinges about z. @param fixed indices of those that never move. @param density [kg/m3] of every other body; the rest
/// have 1000.
World joinedWorld(uint32_t bodies, const std::vector<Joining>& joints, const std::vector<uint32_t>& fixed = {},
                  float density = 1000.0f, const Settings& settings = {});

/// A trunk with two limbs, one with a branch, with every kind of joint; a hinge held by a fixed body; and a single
/// body.
World branchedWorld(const Settings& settings = {});
/// Four bodies of balls in a ring.
World ringWorld();

}  // namespace knuckle::test
