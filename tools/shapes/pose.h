#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "sim/rig/model.h"

/// How figures are posed for their clips: feet are placed first, what is above them follows by two-bone inverse
/// kinematics.
namespace knuckle {

using Heads = std::vector<Eigen::Vector3d>;      ///< Where each bone begins [m].
using Rotations = std::vector<Eigen::Matrix3d>;  ///< Of each, from rest.

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis);
/// From 0 to 1, at rest at both ends.
double smooth(double way);

/// Two bones from `root` towards `root + reach`: where the first one ends and the second, and the plane they lie in.
struct BentLimb {
    Eigen::Vector3d middle, end, normal;
};
/// @param upper, lower how long the bones are [m]. @param pole where the middle points to. What is out of reach is
/// pointed at.
BentLimb bend(const Eigen::Vector3d& root, const Eigen::Vector3d& reach, double upper, double lower,
              const Eigen::Vector3d& pole);
/// The rotation that takes a bone from its direction at rest to another one, and the plane of that and `restPole` to
/// that of a normal.
Eigen::Matrix3d aim(const Eigen::Vector3d& restDirection, const Eigen::Vector3d& restPole,
                    const Eigen::Vector3d& direction, const Eigen::Vector3d& normal);
/// Turns a bone against the one that it hangs on.
void attach(uint32_t bone, uint32_t parent, const Eigen::Matrix3d& local, const Heads& rest, Heads& heads,
            Rotations& rotations);

/// Where a foot is that stands, then swings to where it stands next.
struct Footfall {
    double along;  ///< Ahead of where the hips were at phase 0 [m].
    double stand;  ///< How much of its stand is over, 0 ... 1.
    double way;    ///< How much of its swing is over, 0 ... 1.
    double lift;   ///< 0 on the ground ... 1 in the middle of the swing.
};
/// @param phase in strides since it was set down. @param stride from one stand to the next [m]. @param swing its share
/// of the time, within 0 ... 1. It is set down ahead of the hips by as much as it leaves the ground behind them.
Footfall footfallAt(double phase, double stride, double swing);
/// Once up and down from phase to phase + 1, from 0.
double wave(double phase);

inline constexpr int KEYS_PER_SECOND = 30;  ///< Of every clip.

/// A clip of whole keys. @param pose at a key, from the bones' heads at rest.
Clip makeClip(const std::string& name, double duration, const std::vector<Bone>& bones,
              const std::function<void(int key, const Heads& rest, Heads& heads, Rotations& rotations)>& pose);

}  // namespace knuckle
