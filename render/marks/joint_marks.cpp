#include "render/marks/joint_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "render/marks/mark_pen.h"
#include "sim/base/angles.h"
#include "sim/world/builder/parts/joints.h"
#include "sim/world/space/bounds.h"

namespace knuckle {

namespace {

// In heights of the picture.
constexpr float LINE = 0.0022f, RIB = 0.0015f, AXIS = 0.0065f, DOT = 0.0085f, HUB = 0.006f;
constexpr float LARGEST_FAN = 0.075f;  // of the longest side of the shown box
constexpr float CHILD_PART = 0.55f;    // of the child's reach: radius of a fan
constexpr float SMALLEST_FAN = 4.0f;   // particle radii
constexpr float AXIS_PART = 0.5f;      // of a fan's radius, each way
constexpr int ARC_PARTS = 48;          // of a whole turn
constexpr int RIBS = 8;                // of a cone
// For the legend, in heights of the picture.
constexpr float LEGEND_LEFT = 0.04f, LEGEND_TOP = 0.03f, LEGEND_ROW = 0.034f, LEGEND_INDENT = 0.025f;
constexpr float SYMBOL = 0.0105f, TEXT = 0.0145f;
/// In the order of the legend.
constexpr std::array SHOWN_TYPES{JointType::Ball, JointType::Hinge, JointType::Universal, JointType::Stiff};

/// The joint's type; universal for each of the two hinges of a universal joint.
JointType shownType(const World& world, const Joint& joint)
{
    const bool halved = world.bodies[joint.parent].isCross || world.bodies[joint.child].isCross;
    return halved ? JointType::Universal : joint.type;
}

/// The body that a joint moves: beyond the cross of a universal joint.
const Body& movedBody(const World& world, const Joint& joint)
{
    const auto behind = std::ranges::find(world.joints, joint.child, &Joint::parent);
    const bool onCross = world.bodies[joint.child].isCross && behind != world.joints.end();
    return world.bodies[onCross ? behind->child : joint.child];
}

float fanRadius(const World& world, const Body& moved, const Vector3f& joint, float largest)
{
    float reach = 0.0f;
    for (const Link& link : std::span(world.links).subspan(moved.linkStart, moved.linkCount))
        reach = std::max(reach, (world.particles[link.particle].position - joint).norm());
    return std::min(std::max(CHILD_PART * reach, SMALLEST_FAN * world.particleRadius), largest);
}

/// @param from unit, across the axis. @param range [rad]
void drawSector(MarkPen& pen, const Vector3f& at, const Vector3f& axis, const Vector3f& from, const TurnRange& range)
{
    const float width = range.highest - range.lowest;
    const int parts = std::max(2, static_cast<int>(std::lround(ARC_PARTS * width / WHOLE_TURN)));
    const auto rim = [&](int k) {
        const float angle = range.lowest + width * static_cast<float>(k) / static_cast<float>(parts);
        return Vector3f(at + Eigen::AngleAxisf(angle, axis) * from);
    };
    for (int k = 0; k < parts; ++k) {
        pen.triangle(at, rim(k), rim(k + 1));
        pen.edgedLine(rim(k), rim(k + 1), LINE);
    }
    pen.edgedLine(at, rim(0), LINE);
    pen.edgedLine(at, rim(parts), LINE);
}

/// @param axes of the cone: its middle is x.
void drawCone(MarkPen& pen, const Vector3f& at, const Quaternionf& axes, float radius, float swing)
{
    const auto rim = [&](int k) {
        const float angle = WHOLE_TURN * static_cast<float>(k) / ARC_PARTS;
        const Vector3f way(std::cos(swing), std::sin(swing) * std::cos(angle), std::sin(swing) * std::sin(angle));
        return Vector3f(at + radius * (axes * way));
    };
    for (int k = 0; k < ARC_PARTS; ++k) {
        pen.triangle(at, rim(k), rim(k + 1));
        pen.edgedLine(rim(k), rim(k + 1), LINE);
        if (k % (ARC_PARTS / RIBS) == 0) pen.line(at, rim(k), RIB);
    }
}

/// The mark itself. @param axis of a hinge, drawn to both sides.
void drawSymbol(MarkPen& pen, JointType type, const Vector3f& at, const Vector3f& axis)
{
    if (type == JointType::Ball) return pen.dot(at, DOT, 24);
    if (type == JointType::Stiff) return pen.dot(at, DOT, 4);
    pen.edgedLine(at - axis, at + axis, AXIS);
    pen.dot(at, HUB, 24);
}

void drawJoint(const World& world, const Joint& joint, MarkPen& pen, JointType type, float largest)
{
    const Vector3f& at = joint.parentSide.arm;
    const Vector3f place = world.bodies[joint.parent].restCentre + at;
    const Vector3f axis = joint.parentSide.frame * Vector3f::UnitX();
    const Body& moved = movedBody(world, joint);
    const float radius = fanRadius(world, moved, place, largest);
    const Vector3f toChild = moved.restCentre - place, across = toChild - toChild.dot(axis) * axis;
    const bool turns = joint.type == JointType::Hinge && joint.limits.twist.bounded();
    if (turns && across.norm() > 1e-3f * radius)
        drawSector(pen, at, axis, radius * across.normalized(), joint.limits.twist);
    if (joint.type == JointType::Ball && joint.limits.swing < 0.5f * WHOLE_TURN)
        drawCone(pen, at, joint.parentSide.frame, radius, joint.limits.swing);
    drawSymbol(pen, type, at, AXIS_PART * radius * axis);
}

}  // namespace

Eigen::Vector3f markColor(JointType type)
{
    switch (type) {
        case JointType::Ball: return {0.16f, 0.45f, 0.98f};
        case JointType::Hinge: return {1.0f, 0.66f, 0.05f};
        case JointType::Universal: return {0.80f, 0.30f, 0.95f};
        case JointType::Stiff: break;
    }
    return {0.93f, 0.93f, 0.93f};
}

Marks jointMarks(const World& world, bool legend)
{
    const float largest = LARGEST_FAN * particleBounds(world).sizes().maxCoeff();
    MarkPen pen;
    std::array<bool, SHOWN_TYPES.size()> seen{};
    for (const Joint& joint : world.joints) {
        const JointType type = shownType(world, joint);
        seen[static_cast<size_t>(type)] = true;
        pen.onBody(joint.parent, markColor(type));
        drawJoint(world, joint, pen, type, largest);
    }
    float row = 0.5f;
    for (const JointType type : SHOWN_TYPES) {
        if (!legend || !seen[static_cast<size_t>(type)]) continue;
        const Vector3f at(LEGEND_LEFT, LEGEND_TOP + LEGEND_ROW * row, 0.0f);
        pen.onPicture(markColor(type));
        drawSymbol(pen, type, at, {SYMBOL, 0, 0});
        if (type == JointType::Universal) drawSymbol(pen, type, at, {0, SYMBOL, 0});
        pen.text({LEGEND_LEFT + LEGEND_INDENT, at.y(), 0.0f}, jointTypeName(type), TEXT);
        row += 1.0f;
    }
    return pen.finished();
}

}  // namespace knuckle
