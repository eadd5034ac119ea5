#include "sim/actor/bodies/joint_ranges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

constexpr float DEGREE = std::numbers::pi_v<float> / 180;
constexpr float SPARE = 5 * DEGREE;
/// A limit that is wider is none.
constexpr float WIDEST = 175 * DEGREE;

/// A range as tables have it: from straight, the way that it bends.
TurnRange bendRange(float lowest, float highest, float bend)
{
    return {std::min(lowest * DEGREE - bend, -SPARE), std::max(highest * DEGREE - bend, SPARE)};
}

JointLimits cone(const Vector3f& middle, float swing, float twist)
{
    JointLimits limits;
    limits.cone = middle.normalized();
    limits.swing = swing * DEGREE;
    limits.twist = {-twist * DEGREE, twist * DEGREE};
    return limits;
}

JointLimits ofPart(const LimbStance& s)
{
    const Vector3f up = Vector3f::UnitY();
    const float share = 1.0f / static_cast<float>(s.segments);
    JointLimits limits;
    switch (s.part) {
        // Flexion 80, extension 25, to a side 35, turn 45, of all segments together.
        case BodyPart::Spine:
            return cone(s.along + std::tan(27 * share * DEGREE) * s.forward, 5 + 45 * share, 45 * share);
        // Each way 45, turn 60.
        case BodyPart::Neck:
        case BodyPart::Head: return cone(s.along, 5 + 45 * share, 60 * share);
        case BodyPart::Clavicle: return cone(s.along, 20, 15);
        // Flexion and abduction 180, extension 60, rotation 70 to 90.
        case BodyPart::UpperArm: return cone(0.75f * s.outward + 0.55f * s.forward - 0.2f * up, 105, 90);
        case BodyPart::Forearm: limits.bend = bendRange(0, 150, s.bend); return limits;
        // Flexion 80, extension 70; pronation and supination 80 are the forearm's, which a hinge does not have.
        case BodyPart::Hand: return cone(s.along, 70, 85);
        // Flexion 120, extension 30, abduction 45, adduction 30, rotation 45.
        case BodyPart::Thigh: return cone(-0.77f * up + 0.55f * s.forward + 0.25f * s.outward, 75, 45);
        case BodyPart::Shin: limits.bend = bendRange(0, 140, s.bend); return limits;
        // 20 up, 50 down.
        case BodyPart::Foot: return cone(s.along - 0.27f * up, 35, 25);
        case BodyPart::Toe: limits.bend = bendRange(-40, 70, 0); return limits;
        case BodyPart::Tail: return cone(s.along, 30, 15);
        default: return limits;
    }
}

/// An angle that becomes a range's end where it leaves it.
void widen(TurnRange& range, float angle)
{
    range.lowest = std::min(range.lowest, angle - SPARE);
    range.highest = std::max(range.highest, angle + SPARE);
    if (range.lowest < -WIDEST || range.highest > WIDEST) range = {};
}

float turnAbout(const Vector3f& axis, const Quaternionf& turn)
{
    return std::remainder(2 * std::atan2(turn.vec().dot(axis), turn.w()), 2 * std::numbers::pi_v<float>);
}

bool isNarrow(const TurnRange& range)
{
    return range.highest - range.lowest < SPARE && range.lowest <= 0.0f && range.highest >= 0.0f;
}

void becomeHinge(JointPlan& plan, const Vector3f& axis, const TurnRange& range)
{
    plan.type = JointType::Hinge;
    plan.turnAbout(axis);
    plan.limits = {};
    plan.limits.bend = range;
}

void becomeStiff(JointPlan& plan)
{
    plan.type = JointType::Stiff;
    plan.limits = {};
}

}  // namespace

bool hasRange(BodyPart part)
{
    return part != BodyPart::Other && part != BodyPart::Hips && part != BodyPart::Finger && part != BodyPart::Wing;
}

JointType rangedType(BodyPart part)
{
    const bool hinge = part == BodyPart::Forearm || part == BodyPart::Shin || part == BodyPart::Toe;
    return hinge ? JointType::Hinge : JointType::Ball;
}

JointLimits ordinaryRange(const LimbStance& stance)
{
    JointLimits limits = ofPart(stance);
    if (limits.any()) takeIn(limits, rangedType(stance.part), stance.along, Quaternionf::Identity());
    return limits;
}

void lockNarrowRanges(JointPlan& plan)
{
    const JointLimits limits = plan.limits;
    if (std::isfinite(limits.stiffness)) return;
    const bool bends = !isNarrow(limits.bend), bendsAgain = !isNarrow(limits.secondBend);
    const float lean = limits.cone.isZero() ? 0.0f : std::acos(limits.cone.normalized().dot(plan.twistAxis));
    const bool swings = 2 * limits.swing >= SPARE || lean > limits.swing, twists = !isNarrow(limits.twist);
    switch (plan.type) {
        case JointType::Hinge:
            if (!bends) becomeStiff(plan);
            return;
        case JointType::Ball:
            if (!swings && !twists) becomeStiff(plan);
            if (!swings && twists) becomeHinge(plan, plan.twistAxis, limits.twist);
            return;
        case JointType::Universal:
            if (!bends && !bendsAgain) becomeStiff(plan);
            if (!bends && bendsAgain) becomeHinge(plan, plan.along.cross(plan.axis).normalized(), limits.secondBend);
            if (bends && !bendsAgain) becomeHinge(plan, plan.axis, limits.bend);
            return;
        case JointType::Stiff: return;
    }
}

void takeIn(JointLimits& limits, JointType type, const Vector3f& axis, const Quaternionf& turn)
{
    if (!limits.any()) return;
    if (type == JointType::Hinge) return widen(limits.bend, turnAbout(axis, turn));
    if (type != JointType::Ball) return;
    const Vector3f middle = limits.cone.isZero() ? axis : limits.cone.normalized();
    if (limits.swing < std::numbers::pi_v<float>) {
        const Vector3f now = turn * axis;
        limits.swing = std::max(limits.swing, std::atan2(middle.cross(now).norm(), middle.dot(now)) + SPARE);
        if (limits.swing > WIDEST) limits.swing = std::numbers::pi_v<float>;
    }
    // What is left of the turn when the axis has swung to the middle of its cone.
    const Quaternionf lean = Quaternionf::FromTwoVectors(axis, middle);
    if (limits.twist.bounded()) widen(limits.twist, turnAbout(axis, lean.conjugate() * turn));
}

}  // namespace knuckle
