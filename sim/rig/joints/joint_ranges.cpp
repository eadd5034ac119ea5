#include "sim/rig/joints/joint_ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "sim/base/angles.h"
#include "sim/rig/joints/turn_parts.h"
#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

constexpr float SPARE = LIMIT_SPARE;
constexpr float WIDEST = 175 * DEGREE;  // the largest limit, either way
constexpr float ROUND = 330 * DEGREE;   // of a clip that goes all the way round
constexpr float MORE = 15 * DEGREE;     // further turn of a hinge beyond its clips, besides SPARE

/// A range as in tables: from straight, in the bending direction.
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

/// A creature's knee folds at least 40 degrees, and stretches half way to straight.
TurnRange creatureBend(const LimbStance& s)
{
    const float bend = s.bend / DEGREE, back = std::min(bend, std::max(20.0f, bend / 2));
    return bendRange(bend - back, std::max(140.0f, bend + 40), s.bend);
}

/// Ranges that differ from those of an upright figure.
std::optional<JointLimits> ofCreature(const LimbStance& s)
{
    JointLimits limits;
    switch (s.part) {
        case BodyPart::UpperArm:
        case BodyPart::Thigh: return cone(s.along, 50, 20);
        case BodyPart::Hand:
        case BodyPart::Foot: return cone(s.along, 40, 15);
        case BodyPart::Forearm:
        case BodyPart::Shin: limits.bend = creatureBend(s); return limits;
        default: return {};
    }
}

JointLimits ofPart(const LimbStance& s)
{
    const Vector3f up = Vector3f::UnitY();
    const float share = 1.0f / static_cast<float>(s.segments);
    JointLimits limits;
    switch (s.part) {
        // Flexion 80, extension 25, to a side 35, turn 45, for all segments together.
        case BodyPart::Spine:
            return cone(s.along + std::tan(27 * share * DEGREE) * s.forward, 5 + 45 * share, 45 * share);
        // 45 each way, turn 60.
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
        case BodyPart::Finger: limits.bend = bendRange(-20, 100, s.bend); return limits;
        case BodyPart::Lever: limits.bend = bendRange(-60, 60, 0); return limits;
        case BodyPart::Tail: return cone(s.along, 30, 15);
        case BodyPart::Coxa: return cone(s.along, 30, 20);
        case BodyPart::Wing: return cone(s.along, 60, 30);
        default: return limits;
    }
}

/// The angles about an axis of consecutive turns, which may exceed half a turn. @param near the first.
std::optional<TurnRange> anglesOf(const Vector3f& axis, std::span<const Quaternionf> turns, float near)
{
    std::optional<TurnRange> range;
    for (const Quaternionf& turn : turns) {
        if (!isSureAbout(axis, turn)) continue;
        near += std::remainder(turnAbout(axis, turn) - near, WHOLE_TURN);
        if (!range) range = {near, near};
        range->lowest = std::min(range->lowest, near);
        range->highest = std::max(range->highest, near);
    }
    return range;
}

void widen(TurnRange& range, const Vector3f& axis, std::span<const Quaternionf> turns)
{
    if (!range.bounded()) return;
    const std::optional<TurnRange> angles = anglesOf(axis, turns, 0.5f * (range.lowest + range.highest));
    if (!angles) return;
    if (angles->highest - angles->lowest > ROUND) {
        range = {};
        return;
    }
    range.lowest = std::max(std::min(range.lowest, angles->lowest - SPARE), -WIDEST);
    range.highest = std::min(std::max(range.highest, angles->highest + SPARE), WIDEST);
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
    return part != BodyPart::Other && part != BodyPart::Hips;
}

JointType rangedType(BodyPart part)
{
    return jointTypeOf(part) == JointType::Hinge ? JointType::Hinge : JointType::Ball;
}

JointLimits ordinaryRange(const LimbStance& stance)
{
    const std::optional<JointLimits> creatures = stance.upright ? std::nullopt : ofCreature(stance);
    JointLimits limits = creatures ? *creatures : ofPart(stance);
    const std::array rest{Quaternionf::Identity()};
    takeIn(limits, rangedType(stance.part), stance.along, rest);
    return limits;
}

JointLimits rangeInClips(const Vector3f& axis, std::span<const std::vector<Quaternionf>> clips)
{
    JointLimits limits;
    TurnRange range{0.0f, 0.0f};
    for (const std::vector<Quaternionf>& turns : clips) {
        const TurnRange angles = anglesOf(axis, turns, 0.0f).value_or(range);
        range.lowest = std::min(range.lowest, angles.lowest - SPARE);
        range.highest = std::max(range.highest, angles.highest + SPARE);
    }
    if (range.lowest < -WIDEST || range.highest > WIDEST) return limits;
    limits.bend = {std::max(range.lowest - MORE, -WIDEST), std::min(range.highest + MORE, WIDEST)};
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

void takeIn(JointLimits& limits, JointType type, const Vector3f& axis, std::span<const Quaternionf> turns)
{
    if (!limits.any()) return;
    if (type == JointType::Hinge) return widen(limits.bend, axis, turns);
    if (type != JointType::Ball) return;
    const Vector3f middle = limits.cone.isZero() ? axis : limits.cone.normalized();
    // The rest of a turn after the axis has swung to the middle of its cone.
    const Quaternionf lean = turnBetween(axis, middle);
    std::vector<Quaternionf> twists;
    for (const Quaternionf& turn : turns) {
        twists.push_back(lean.conjugate() * turn);
        const Vector3f now = turn * axis;
        limits.swing = std::max(limits.swing, std::atan2(middle.cross(now).norm(), middle.dot(now)) + SPARE);
    }
    if (limits.swing > WIDEST) limits.swing = HALF_TURN;
    widen(limits.twist, axis, twists);
}

void leanTo(JointLimits& limits, const Vector3f& axis, std::span<const Quaternionf> turns)
{
    if (limits.swing >= WIDEST) return;
    Vector3f middle = limits.cone.isZero() ? axis : limits.cone.normalized();
    for (const Quaternionf& turn : turns) {
        const Vector3f now = turn * axis, about = middle.cross(now);
        const float beyond = std::atan2(about.norm(), middle.dot(now)) + SPARE - limits.swing;
        if (beyond <= 0.0f || about.isZero()) continue;
        limits.swing += 0.5f * beyond;
        middle = Eigen::AngleAxisf(0.5f * beyond, about.normalized()) * middle;
        limits.cone = middle;
    }
}

}  // namespace knuckle
