#include <fmt/format.h>

#include <cmath>

#include "app/files/robot/robot.h"
#include "app/report/markup.h"

namespace knuckle {

namespace {

/// Of the links between the turns of a joint: simulators want some [kg].
constexpr float BETWEEN_MASS = 1e-3f;
/// Beyond what any figure needs: the format wants both [N m], [rad/s].
constexpr float EFFORT = 1000.0f, VELOCITY = 100.0f;

std::string inertial(float mass, const Vector3f& centre, const Eigen::Matrix3f& i)
{
    return fmt::format(
        "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{:.6g}\"/>\n"
        "      <inertia ixx=\"{:.6g}\" ixy=\"{:.6g}\" ixz=\"{:.6g}\" iyy=\"{:.6g}\" iyz=\"{:.6g}\" izz=\"{:.6g}\"/>\n"
        "    </inertial>\n",
        numbersOf(centre), mass, i(0, 0), i(0, 1), i(0, 2), i(1, 1), i(1, 2), i(2, 2));
}

/// Angles that turn +Z along a direction: about x first, then about the fixed y.
std::string angles(const Vector3f& z)
{
    return fmt::format("{:.6g} {:.6g} 0", std::atan2(-z.y(), std::hypot(z.x(), z.z())), std::atan2(z.x(), z.z()));
}

/// A capsule as a cylinder between two balls, since the format has none. @param kind visual or collision
std::string shape(const RobotLink& link, const char* kind)
{
    std::string text;
    const auto add = [&](const Vector3f& place, const std::string& turn, const std::string& geometry) {
        text += fmt::format(
            "    <{0}>\n      <origin xyz=\"{1}\" rpy=\"{2}\"/>\n      <geometry>{3}</geometry>\n    </{0}>\n", kind,
            numbersOf(place - link.origin), turn, geometry);
    };
    const Vector3f along = link.ends[1] - link.ends[0];
    const std::string ball = fmt::format("<sphere radius=\"{:.6g}\"/>", link.radius);
    add(link.ends[0], "0 0 0", ball);
    if (along.norm() < 1e-4f) return text;
    add(link.ends[1], "0 0 0", ball);
    add(0.5f * (link.ends[0] + link.ends[1]), angles(along.normalized()),
        fmt::format("<cylinder radius=\"{:.6g}\" length=\"{:.6g}\"/>", link.radius, along.norm()));
    return text;
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child, const Vector3f& place,
                  const RobotTurn* turn)
{
    const bool isBounded = turn != nullptr && turn->range.bounded();
    std::string text = fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n"
        "    <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n",
        escapedMarkup(name),
        turn == nullptr ? "fixed"
        : isBounded     ? "revolute"
                        : "continuous",
        escapedMarkup(parent), escapedMarkup(child), numbersOf(place));
    if (turn != nullptr) text += fmt::format("    <axis xyz=\"{}\"/>\n", numbersOf(turn->axis));
    if (isBounded)
        text += fmt::format("    <limit lower=\"{:.6g}\" upper=\"{:.6g}\" effort=\"{:g}\" velocity=\"{:g}\"/>\n",
                            turn->range.lowest, turn->range.highest, EFFORT, VELOCITY);
    return text + "  </joint>\n";
}

/// A link's joints, with what stands between them.
std::string joints(const RobotLink& link, const RobotLink& parent)
{
    const Vector3f place = link.origin - parent.origin;
    if (link.turns.empty()) return joint(link.name + "_joint", parent.name, link.name, place, nullptr);
    std::string text, from = parent.name;
    for (size_t k = 0; k < link.turns.size(); ++k) {
        const bool isLast = k + 1 == link.turns.size();
        const std::string to = isLast ? link.name : fmt::format("{}_between_{}", link.name, k + 1);
        if (!isLast)
            text += fmt::format("  <link name=\"{}\">\n{}  </link>\n", escapedMarkup(to),
                                inertial(BETWEEN_MASS, {0, 0, 0}, hingeInertia(link) * Eigen::Matrix3f::Identity()));
        text += joint(link.turns[k].name, from, to, k == 0 ? place : Vector3f(0, 0, 0), &link.turns[k]);
        from = to;
    }
    return text;
}

}  // namespace

std::string urdfOf(const Robot& robot)
{
    std::string text = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", escapedMarkup(robot.name));
    for (const RobotLink& link : robot.links) {
        text += fmt::format("  <link name=\"{}\">\n{}{}{}  </link>\n", escapedMarkup(link.name),
                            inertial(link.mass, link.centre - link.origin, link.inertia), shape(link, "visual"),
                            shape(link, "collision"));
        if (link.parent >= 0) text += joints(link, robot.links[static_cast<size_t>(link.parent)]);
    }
    return text + "</robot>\n";
}

}  // namespace knuckle
