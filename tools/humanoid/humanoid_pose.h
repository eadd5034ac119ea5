#pragma once

#include "tools/humanoid/humanoid.h"
#include "tools/shapes/pose.h"

namespace knuckle {

struct Leg {
    HumanoidBone thigh, shin, foot;
    double side;  ///< +1 left
};
inline constexpr Leg LEFT_LEG{THIGH_L, SHIN_L, FOOT_L, 1.0}, RIGHT_LEG{THIGH_R, SHIN_R, FOOT_R, -1.0};

/// The required place of an ankle, the turn of its foot, and the direction of its knee.
struct Ankle {
    Eigen::Vector3d place;
    Eigen::Matrix3d rotation;
    Eigen::Vector3d front;
};

/// In the chest's directions: how high an arm points, how far forward from sideways, how far elbow and hand bend
/// [degrees].
struct Arm {
    double high, forward, elbow, wrist;
};

void poseLeg(const Leg& leg, const Ankle& ankle, const Heads& rest, Heads& heads, Rotations& rotations);
/// @param clavicle of the left or the right.
void poseArm(uint32_t clavicle, const Arm& arm, const Heads& rest, Heads& heads, Rotations& rotations);

}  // namespace knuckle
