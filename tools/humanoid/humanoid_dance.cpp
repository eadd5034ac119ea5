#include <array>
#include <cmath>
#include <numbers>

#include "tools/humanoid/humanoid.h"

// The dance: eight beats of half a second. The feet are placed first (they step on the spot, two beats a side), the
// hips sway over them, and the knees follow by two-bone inverse kinematics, so that no foot can pass the floor.
namespace knuckle {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double DURATION = 4.0;  // [s]
constexpr int KEYS_PER_SECOND = 24;
constexpr double CROUCH = 0.055;      // the hips hang this much lower than at rest, at least [m]
constexpr double STEP_HEIGHT = 0.11;  // [m]

using Heads = std::array<Vector3d, HUMANOID_BONE_COUNT>;
using Rotations = std::array<Matrix3d, HUMANOID_BONE_COUNT>;

Matrix3d turn(double degrees, const Vector3d& axis)
{
    return AngleAxisd(degrees * std::numbers::pi / 180.0, axis).toRotationMatrix();
}

// Columns: along, the part of `pole` across it, their cross product.
Matrix3d frame(const Vector3d& along, const Vector3d& pole)
{
    Matrix3d m;
    m.col(0) = along.normalized();
    m.col(1) = (pole - pole.dot(m.col(0)) * m.col(0)).normalized();
    m.col(2) = m.col(0).cross(m.col(1));
    return m;
}

// The rotation that takes one direction to another while keeping the knee's front towards the pole.
Matrix3d aim(const Vector3d& restDirection, const Vector3d& direction, const Vector3d& pole)
{
    return frame(direction, pole) * frame(restDirection, Vector3d::UnitZ()).transpose();
}

struct Leg {
    HumanoidBone thigh, shin, foot;
    double side;  // +1 left
};

// How high the foot stands at beat phase `beats`: up on every fourth beat, both sides in turn, smooth at both ends.
double footLift(double beats, double side)
{
    const double wave = std::sin(0.5 * std::numbers::pi * beats) * side;
    return wave > 0.0 ? wave * wave : 0.0;
}

void poseLeg(const Leg& leg, const Heads& rest, double beats, Heads& heads, Rotations& rotations)
{
    const double lift = footLift(beats, leg.side);
    const Vector3d hip = heads[HIPS] + rotations[HIPS] * (rest[leg.thigh] - rest[HIPS]);
    const Vector3d ankle = rest[leg.foot] + Vector3d(0.03 * leg.side * lift, STEP_HEIGHT * lift, 0.06 * lift);
    const Vector3d upper = rest[leg.shin] - rest[leg.thigh], lower = rest[leg.foot] - rest[leg.shin];
    const double a = upper.norm(), b = lower.norm();
    const Vector3d reach = ankle - hip;
    const double c = std::min(reach.norm(), 0.9995 * (a + b));
    const double along = (a * a - b * b + c * c) / (2.0 * c);
    const Vector3d pole = rotations[HIPS] * Vector3d(0.12 * leg.side, 0, 1);
    const Matrix3d f = frame(reach, pole);
    const Vector3d knee = hip + along * f.col(0) + std::sqrt(std::max(a * a - along * along, 0.0)) * f.col(1);
    heads[leg.thigh] = hip;
    heads[leg.shin] = knee;
    heads[leg.foot] = hip + c * f.col(0);
    rotations[leg.thigh] = aim(upper, knee - hip, pole);
    rotations[leg.shin] = aim(lower, heads[leg.foot] - knee, pole);
    rotations[leg.foot] = turn(14.0 * leg.side * lift, Vector3d::UnitY());  // flat, turned out while it is up
}

void attach(uint32_t bone, uint32_t parent, const Matrix3d& local, const Heads& rest, Heads& heads,
            Rotations& rotations)
{
    heads[bone] = heads[parent] + rotations[parent] * (rest[bone] - rest[parent]);
    rotations[bone] = rotations[parent] * local;
}

// Left: rotations about +z lift the arm. The two arms trade places every four beats: one waves high, one pumps low.
void poseArm(uint32_t clavicle, double side, double beats, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const double slow = 0.5 * (1.0 + side * std::sin(0.25 * std::numbers::pi * beats));  // 0 low, 1 high
    const double beat = std::sin(std::numbers::pi * beats);
    const double half = std::sin(0.5 * std::numbers::pi * beats + 0.4);
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    attach(clavicle, CHEST, turn(side * (3.0 + 9.0 * slow), z), rest, heads, rotations);
    const Matrix3d shoulder = turn(-14.0 * (1.0 - slow) + 8.0 * half, x) *
                              turn(side * (22.0 + 58.0 * slow + 9.0 * beat), z);
    attach(clavicle + 1, clavicle, shoulder, rest, heads, rotations);
    // Low: the forearm comes forward. High: it stands up and waves.
    const Matrix3d elbow = turn(-side * (1.0 - slow) * (62.0 + 18.0 * beat), y) *
                           turn(side * slow * (48.0 + 24.0 * half), z);
    attach(clavicle + 2, clavicle + 1, elbow, rest, heads, rotations);
    attach(clavicle + 3, clavicle + 2, turn(side * 18.0 * half, z), rest, heads, rotations);
}

void poseBody(double beats, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const double sway = -std::sin(0.5 * std::numbers::pi * beats);  // over the standing foot
    const double bob = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * beats);
    const double slow = std::sin(0.25 * std::numbers::pi * beats);
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    heads[HIPS] = rest[HIPS] + Vector3d(0.055 * sway, -CROUCH - 0.03 * bob, 0.012 * slow);
    rotations[HIPS] = turn(9.0 * slow, y) * turn(-5.0 * sway, z) * turn(4.0, x);
    attach(SPINE, HIPS, turn(4.0 * sway, z) * turn(3.0 * slow, y), rest, heads, rotations);
    attach(CHEST, SPINE, turn(7.0 * sway, z) * turn(-14.0 * slow, y) * turn(-3.0 + 5.0 * bob, x), rest, heads,
           rotations);
    attach(NECK, CHEST, turn(-4.0 * sway, z) * turn(3.0 * bob, x), rest, heads, rotations);
    attach(HEAD, NECK, turn(-5.0 * sway, z) * turn(8.0 * slow, y) * turn(7.0 * bob - 3.0, x), rest, heads, rotations);
}

std::vector<Eigen::Matrix4f> danceAt(double beats, const Heads& rest)
{
    Heads heads;
    Rotations rotations;
    poseBody(beats, rest, heads, rotations);
    poseArm(CLAVICLE_L, 1.0, beats, rest, heads, rotations);
    poseArm(CLAVICLE_R, -1.0, beats, rest, heads, rotations);
    poseLeg({THIGH_L, SHIN_L, FOOT_L, 1.0}, rest, beats, heads, rotations);
    poseLeg({THIGH_R, SHIN_R, FOOT_R, -1.0}, rest, beats, heads, rotations);
    std::vector<Eigen::Matrix4f> poses(HUMANOID_BONE_COUNT, Eigen::Matrix4f::Identity());
    for (uint32_t b = 0; b < HUMANOID_BONE_COUNT; ++b) {
        poses[b].topLeftCorner<3, 3>() = rotations[b].cast<float>();
        poses[b].block<3, 1>(0, 3) = heads[b].cast<float>();
    }
    return poses;
}

}  // namespace

Clip humanoidDance(const std::vector<Bone>& bones)
{
    Heads rest;
    for (uint32_t b = 0; b < HUMANOID_BONE_COUNT; ++b) {
        rest[b] = bones[b].restPose.block<3, 1>(0, 3).cast<double>();
    }
    Clip clip;
    clip.name = "dance";
    clip.duration = DURATION;
    const int keys = static_cast<int>(DURATION * KEYS_PER_SECOND);
    for (int k = 0; k <= keys; ++k) {
        clip.keyTimes.push_back(static_cast<double>(k) / KEYS_PER_SECOND);
        // The last key is the first again, to the bit.
        clip.poses.push_back(danceAt(2.0 * (k % keys) / KEYS_PER_SECOND, rest));
    }
    return clip;
}

}  // namespace knuckle
