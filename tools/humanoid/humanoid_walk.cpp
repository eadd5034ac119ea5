#include <cmath>

#include "tools/humanoid/humanoid_pose.h"

// The walk: two steps of 0.55 m. A foot stands for three fifths of the time and swings for the rest; arms swing
// opposite to the legs.
namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int KEYS = 33;            // of two steps
constexpr double DURATION = 1.1;    // of both [s]
constexpr double STRIDE = 1.1;      // from one stand of a foot to its next [m]
constexpr double SWING = 0.4;       // share of the time
constexpr double CROUCH = 0.035;    // how much lower than at rest the hips are [m]
constexpr double FOOT_LIFT = 0.11;  // [m]
constexpr double TOE = 0.19;        // from the ankle ahead to the toes, over which the foot rolls [m]

// Place of a foot `phase` strides after it was set down under its hip: it stands, then swings to the next place.
Ankle ankleAt(const Leg& leg, const Heads& rest, double phase)
{
    const auto [along, stand, way, lift] = footfallAt(phase, STRIDE, SWING);
    const double part = phase - std::floor(phase);
    // The heel rises before the foot does, and comes down first.
    const double heel = smooth((part - 0.4) / 0.2) * (1.0 - smooth(way / 0.7)), toes = lift * way;
    const Matrix3d tilt = turn(30.0 * heel, Vector3d::UnitX()), raised = turn(-18.0 * toes, Vector3d::UnitX());
    const Vector3d toe(0, -rest[leg.foot].y(), TOE), place = rest[leg.foot] + Vector3d(0, FOOT_LIFT * lift, along);
    return {place + toe - tilt * toe, tilt * raised, Vector3d::UnitZ()};
}

void poseBody(double phase, const Heads& rest, Heads& heads, Rotations& rotations)
{
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    // Highest over the standing foot, and shifted towards it.
    const double bob = -0.02 * wave(2.0 * phase + 0.15), sway = wave(phase);
    heads[HIPS] = rest[HIPS] + Vector3d(0.025 * sway, bob - CROUCH, STRIDE * phase);
    rotations[HIPS] = turn(-7.0 * wave(phase + 0.25), y) * turn(2.5 * sway, z) * turn(3.0, x);
    attach(SPINE, HIPS, turn(-2.5 * sway, z) * turn(5.0 * wave(phase + 0.25), y), rest, heads, rotations);
    attach(CHEST, SPINE, turn(8.0 * wave(phase + 0.25), y) * turn(2.0, x), rest, heads, rotations);
    attach(NECK, CHEST, turn(-3.0 * wave(phase + 0.25), y), rest, heads, rotations);
    attach(HEAD, NECK, turn(-3.0 * wave(phase + 0.25), y) * turn(-5.0, x), rest, heads, rotations);
}

// An arm swings back while its leg goes ahead.
Arm armAt(double phase)
{
    const double ahead = -wave(phase + 0.25);
    return {-66.0 - 4.0 * ahead, 15.0 + 62.0 * ahead, 22.0 + 14.0 * ahead, 0.0};
}

}  // namespace

Clip humanoidWalk(const std::vector<Bone>& bones)
{
    return makeClip("walk", DURATION, bones, [](int key, const Heads& rest, Heads& heads, Rotations& rotations) {
        const double phase = static_cast<double>(key) / KEYS;
        poseBody(phase, rest, heads, rotations);
        poseArm(CLAVICLE_L, armAt(phase), rest, heads, rotations);
        poseArm(CLAVICLE_R, armAt(phase + 0.5), rest, heads, rotations);
        poseLeg(LEFT_LEG, ankleAt(LEFT_LEG, rest, phase), rest, heads, rotations);
        // Half a stride later.
        Ankle right = ankleAt(RIGHT_LEG, rest, phase + 0.5);
        right.place.z() -= 0.5 * STRIDE;
        poseLeg(RIGHT_LEG, right, rest, heads, rotations);
    });
}

}  // namespace knuckle
