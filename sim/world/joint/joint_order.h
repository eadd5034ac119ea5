#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Keeps track of which bodies of shared particles are connected.
class SharedParticles {
public:
    /// @returns whether the two were not connected through this particle before.
    bool connect(uint32_t particle, uint32_t a, uint32_t b);

private:
    std::map<uint32_t, std::map<uint32_t, uint32_t>> groups_;  ///< Per particle and body: bodies of a group have one.
};

/// A joint between bodies that other joints connect already.
struct LoopJoint {
    uint32_t joint = 0;               ///< Of World::joints.
    std::vector<uint32_t> particles;  ///< Those through which no earlier joint holds its bodies together.
};

/// Which joints connect bodies as trees, and which close loops in them.
struct JointOrder {
    std::vector<uint32_t> connecting;  ///< Of World::joints.
    std::vector<LoopJoint> loops;      ///< Joints that hold anything in addition.
};

/// Bodies that never respond count as one; joints between two of them are left out.
JointOrder orderJoints(const World& world);

}  // namespace knuckle
