#include "tools/humanoid/humanoid_pose.h"

#include <cmath>
#include <numbers>

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void poseLeg(const Leg& leg, const Ankle& ankle, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const Vector3d hip = heads[HIPS] + rotations[HIPS] * (rest[leg.thigh] - rest[HIPS]);
    const Vector3d upper = rest[leg.shin] - rest[leg.thigh], lower = rest[leg.foot] - rest[leg.shin];
    const Vector3d pole = ankle.front + 0.12 * leg.side * (rotations[HIPS] * Vector3d::UnitX());
    const BentLimb bent = bend(hip, ankle.place - hip, upper.norm(), lower.norm(), pole);
    heads[leg.thigh] = hip;
    heads[leg.shin] = bent.middle;
    heads[leg.foot] = bent.end;
    rotations[leg.thigh] = aim(upper, Vector3d::UnitZ(), bent.middle - hip, bent.normal);
    rotations[leg.shin] = aim(lower, Vector3d::UnitZ(), bent.end - bent.middle, bent.normal);
    rotations[leg.foot] = ankle.rotation;
}

void poseArm(uint32_t clavicle, const Arm& arm, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const double side = clavicle == CLAVICLE_L ? 1.0 : -1.0;
    const double rad = std::numbers::pi / 180.0, high = arm.high * rad, forward = arm.forward * rad;
    const Vector3d wanted(side * std::cos(high) * std::cos(forward), std::sin(high),
                          std::cos(high) * std::sin(forward));
    const Vector3d upper = rest[clavicle + 2] - rest[clavicle + 1], lower = rest[clavicle + 3] - rest[clavicle + 2];
    attach(clavicle, CHEST, turn(side * 0.12 * (arm.high + 40.0), Vector3d::UnitZ()), rest, heads, rotations);
    const Matrix3d shoulder = Eigen::Quaterniond::FromTwoVectors(upper, wanted).toRotationMatrix();
    attach(clavicle + 1, clavicle, rotations[clavicle].transpose() * rotations[CHEST] * shoulder, rest, heads,
           rotations);
    // The elbow is a hinge: the forearm comes forward.
    attach(clavicle + 2, clavicle + 1, turn(arm.elbow, lower.cross(Vector3d::UnitZ())), rest, heads, rotations);
    attach(clavicle + 3, clavicle + 2, turn(side * arm.wrist, Vector3d::UnitZ()), rest, heads, rotations);
}

}  // namespace knuckle
