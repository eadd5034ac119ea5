#include "tools/humanoid/humanoid_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int KEYS_PER_SECOND = 30;

// Columns: along, the part of `pole` across it, their cross product.
Matrix3d frame(const Vector3d& along, const Vector3d& pole)
{
    Matrix3d m;
    m.col(0) = along.normalized();
    m.col(1) = (pole - pole.dot(m.col(0)) * m.col(0)).normalized();
    m.col(2) = m.col(0).cross(m.col(1));
    return m;
}

// The rotation that takes one direction to another and the limb's own plane, which at rest faces forward, to that of a
// normal.
Matrix3d aim(const Vector3d& restDirection, const Vector3d& direction, const Vector3d& normal)
{
    Matrix3d m;
    m.col(0) = direction.normalized();
    m.col(1) = normal.cross(m.col(0)).normalized();
    m.col(2) = m.col(0).cross(m.col(1));
    return m * frame(restDirection, Vector3d::UnitZ()).transpose();
}

}  // namespace

Matrix3d turn(double degrees, const Vector3d& axis)
{
    return AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()).toRotationMatrix();
}

double smooth(double way)
{
    const double t = std::clamp(way, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void attach(uint32_t bone, uint32_t parent, const Matrix3d& local, const Heads& rest, Heads& heads,
            Rotations& rotations)
{
    heads[bone] = heads[parent] + rotations[parent] * (rest[bone] - rest[parent]);
    rotations[bone] = rotations[parent] * local;
}

void poseLeg(const Leg& leg, const Ankle& ankle, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const Vector3d hip = heads[HIPS] + rotations[HIPS] * (rest[leg.thigh] - rest[HIPS]);
    const Vector3d upper = rest[leg.shin] - rest[leg.thigh], lower = rest[leg.foot] - rest[leg.shin];
    const double a = upper.norm(), b = lower.norm();
    const Vector3d reach = ankle.place - hip;
    const double c = std::min(reach.norm(), 0.9995 * (a + b));
    const double along = (a * a - b * b + c * c) / (2.0 * c);
    const Vector3d pole = ankle.front + 0.12 * leg.side * (rotations[HIPS] * Vector3d::UnitX());
    const Matrix3d f = frame(reach, pole);
    const Vector3d knee = hip + along * f.col(0) + std::sqrt(std::max(a * a - along * along, 0.0)) * f.col(1);
    heads[leg.thigh] = hip;
    heads[leg.shin] = knee;
    heads[leg.foot] = hip + c * f.col(0);
    rotations[leg.thigh] = aim(upper, knee - hip, f.col(2));
    rotations[leg.shin] = aim(lower, heads[leg.foot] - knee, f.col(2));
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
    // The elbow is a hinge: its forearm comes forward.
    attach(clavicle + 2, clavicle + 1, turn(arm.elbow, lower.cross(Vector3d::UnitZ())), rest, heads, rotations);
    attach(clavicle + 3, clavicle + 2, turn(side * arm.wrist, Vector3d::UnitZ()), rest, heads, rotations);
}

Clip makeClip(const std::string& name, double duration, const std::vector<Bone>& bones,
              const std::function<void(int key, const Heads& rest, Heads& heads, Rotations& rotations)>& pose)
{
    Heads rest;
    for (uint32_t b = 0; b < HUMANOID_BONE_COUNT; ++b) rest[b] = bones[b].restPose.block<3, 1>(0, 3).cast<double>();
    Clip clip;
    clip.name = name;
    clip.duration = duration;
    const int keys = static_cast<int>(std::lround(duration * KEYS_PER_SECOND));
    for (int k = 0; k <= keys; ++k) {
        Heads heads;
        Rotations rotations;
        pose(k, rest, heads, rotations);
        std::vector<Eigen::Matrix4f> poses(HUMANOID_BONE_COUNT, Eigen::Matrix4f::Identity());
        for (uint32_t b = 0; b < HUMANOID_BONE_COUNT; ++b) {
            poses[b].topLeftCorner<3, 3>() = rotations[b].cast<float>();
            poses[b].block<3, 1>(0, 3) = heads[b].cast<float>();
        }
        clip.keyTimes.push_back(static_cast<double>(k) / KEYS_PER_SECOND);
        clip.poses.push_back(poses);
    }
    return clip;
}

}  // namespace knuckle
