#include <cmath>

#include "tools/shapes/pose.h"
#include "tools/spider/spider_parts.h"

// Feet are placed first. A hip turns its leg about the body's upright axis until it is in line with the foot, and the
// two further hinges do the rest.
namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int KEYS = 24;                                    // of a stride
constexpr double STRIDE = 0.40, SWING = 0.46, LIFT = 0.10;  // between stands [m], share of the time, height [m]

struct Pose {
    const Skeleton& skeleton;
    const Heads& rest;
    Heads& heads;
    Rotations& rotations;
};

void poseLeg(const Pose& pose, uint32_t coxa, double phase, double set)
{
    const uint32_t femur = coxa + 1, tibia = coxa + 2;
    const Vector3d foot = pose.skeleton[tibia].tail;
    const Footfall fall = footfallAt(phase - set + 1.0, STRIDE, SWING);
    const Vector3d place = foot + Vector3d(0, LIFT * fall.lift, fall.along + (set - 1.0) * STRIDE);

    const Matrix3d body = pose.rotations[0];
    const Vector3d up = body * Vector3d::UnitY(), hip = pose.heads[0] + body * (pose.rest[coxa] - pose.rest[0]);
    const auto flat = [](const Vector3d& way, const Vector3d& axis) {
        return (way - way.dot(axis) * axis).normalized();
    };
    const Vector3d before = body * flat(pose.rest[femur] - pose.rest[coxa], Vector3d::UnitY());
    const Vector3d out = flat(place - hip, up);
    const double angle = std::atan2(before.cross(out).dot(up), before.dot(out));
    pose.heads[coxa] = hip;
    pose.rotations[coxa] = Eigen::AngleAxisd(angle, up).toRotationMatrix() * body;
    attach(femur, coxa, Matrix3d::Identity(), pose.rest, pose.heads, pose.rotations);
    const Vector3d upper = pose.rest[tibia] - pose.rest[femur], lower = foot - pose.rest[tibia];
    const Vector3d root = pose.heads[femur];
    const BentLimb bent = bend(root, place - root, upper.norm(), lower.norm(), up);
    pose.heads[tibia] = bent.middle;
    pose.rotations[femur] = aim(upper, Vector3d::UnitY(), bent.middle - root, bent.normal);
    pose.rotations[tibia] = aim(lower, Vector3d::UnitY(), bent.end - bent.middle, bent.normal);
}

}  // namespace

Clip spiderWalk(const Skeleton& skeleton)
{
    const auto poseKey = [&](int key, const Heads& rest, Heads& heads, Rotations& rotations) {
        const double phase = static_cast<double>(key) / KEYS;
        const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
        heads[0] = rest[0] + Vector3d(0.006 * wave(phase), 0.008 * wave(2.0 * phase + 0.1), STRIDE * phase);
        rotations[0] = turn(2.0 * wave(phase + 0.2), y) * turn(1.8 * wave(phase), z) * turn(1.0 * wave(2.0 * phase), x);
        attach(boneIndex(skeleton, "abdomen"), 0, turn(4.0 * wave(phase + 0.1), y) * turn(3.0 * wave(2.0 * phase), x),
               rest, heads, rotations);
        attach(boneIndex(skeleton, "head"), 0, turn(12.0 * wave(phase + 0.3), y) * turn(3.0 * wave(2.0 * phase), x),
               rest, heads, rotations);
        const Pose pose{skeleton, rest, heads, rotations};
        for (const SpiderLeg& leg : SPIDER_LEGS) {
            const uint32_t left = boneIndex(skeleton, leg.bones[0]);
            poseLeg(pose, left, phase, leg.phase);
            poseLeg(pose, left + 3, phase, 0.5 - leg.phase);  // its mirror image follows
        }
    };
    return makeClip("walk", static_cast<double>(KEYS) / KEYS_PER_SECOND, bonesOf(skeleton), poseKey);
}

}  // namespace knuckle
