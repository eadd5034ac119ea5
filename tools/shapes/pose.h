#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "sim/rig/model.h"

/// Poses of figures for their clips: feet are placed first, the bones above them follow by two-bone inverse kinematics.
namespace knuckle {

using Heads = std::vector<Eigen::Vector3d>;      ///< Start of each bone [m].
using Rotations = std::vector<Eigen::Matrix3d>;  ///< Of each bone, from rest.

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis);
/// From 0 to 1, at rest at both ends.
double smooth(double way);

/// Two bones from `root` towards `root + reach`: ends of the first and the second, and the plane of both.
struct BentLimb {
    Eigen::Vector3d middle, end, normal;
};
/// @param upper, lower lengths of the bones [m]. @param pole direction of the middle. If the reach is too long, the
/// bones point at its end.
BentLimb bend(const Eigen::Vector3d& root, const Eigen::Vector3d& reach, double upper, double lower,
              const Eigen::Vector3d& pole);
/// The rotation that takes a bone from its direction at rest to another one, and the plane of that direction and
/// `restPole` to the plane of a normal.
Eigen::Matrix3d aim(const Eigen::Vector3d& restDirection, const Eigen::Vector3d& restPole,
                    const Eigen::Vector3d& direction, const Eigen::Vector3d& normal);
/// Turns a bone against its parent.
void attach(uint32_t bone, uint32_t parent, const Eigen::Matrix3d& local, const Heads& rest, Heads& heads,
            Rotations& rotations);

/// State of a foot that stands, then swings to its next stand.
struct Footfall {
    double along;  ///< Ahead of where the hips were at phase 0 [m].
    double stand;  ///< The part of its stand that is over, 0 ... 1.
    double way;    ///< The part of its swing that is over, 0 ... 1.
    double lift;   ///< 0 on the ground ... 1 in the middle of the swing.
};
/// @param phase in strides since it was set down. @param stride from one stand to the next [m]. @param swing its share
/// of the time, within 0 ... 1. The foot is set down as far ahead of the hips as it leaves the ground behind them.
Footfall footfallAt(double phase, double stride, double swing);
/// Goes up and down once from phase to phase + 1, starting at 0.
double wave(double phase);

inline constexpr int KEYS_PER_SECOND = 30;  ///< In every clip.

/// A clip with whole keys. @param pose at a key, from the bones' heads at rest.
Clip makeClip(const std::string& name, double duration, const std::vector<Bone>& bones,
              const std::function<void(int key, const Heads& rest, Heads& heads, Rotations& rotations)>& pose);

}  // namespace knuckle
