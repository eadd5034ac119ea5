#pragma once

#include <array>
#include <functional>
#include <string>

#include "tools/humanoid/humanoid.h"

/// How the figure is posed for its clips: feet are placed first, knees follow by two-bone inverse kinematics.
namespace knuckle {

using Heads = std::array<Eigen::Vector3d, HUMANOID_BONE_COUNT>;      ///< Where each bone begins [m].
using Rotations = std::array<Eigen::Matrix3d, HUMANOID_BONE_COUNT>;  ///< Of each, from rest.

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis);
/// From 0 to 1, at rest at both ends.
double smooth(double way);

struct Leg {
    HumanoidBone thigh, shin, foot;
    double side;  ///< +1 left
};
inline constexpr Leg LEFT_LEG{THIGH_L, SHIN_L, FOOT_L, 1.0}, RIGHT_LEG{THIGH_R, SHIN_R, FOOT_R, -1.0};

/// Where an ankle has to be, how its foot is turned, and where its knee looks.
struct Ankle {
    Eigen::Vector3d place;
    Eigen::Matrix3d rotation;
    Eigen::Vector3d front;
};

/// In the chest's directions: how high an arm points, how far forward of sideways, how far elbow and hand bend
/// [degrees].
struct Arm {
    double high, forward, elbow, wrist;
};

/// Turns a bone against the one that it hangs on.
void attach(uint32_t bone, uint32_t parent, const Eigen::Matrix3d& local, const Heads& rest, Heads& heads,
            Rotations& rotations);
void poseLeg(const Leg& leg, const Ankle& ankle, const Heads& rest, Heads& heads, Rotations& rotations);
/// @param clavicle of the left or the right.
void poseArm(uint32_t clavicle, const Arm& arm, const Heads& rest, Heads& heads, Rotations& rotations);

/// A clip of 30 keys a second. @param pose at a key, from the bones' heads at rest.
Clip makeClip(const std::string& name, double duration, const std::vector<Bone>& bones,
              const std::function<void(int key, const Heads& rest, Heads& heads, Rotations& rotations)>& pose);

}  // namespace knuckle
