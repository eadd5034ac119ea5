#include <fmt/format.h>

#include "app/files/robot/robot.h"
#include "app/report/markup.h"

namespace knuckle {

namespace {

/// @param armature beside the link's own inertia [kg m2].
std::string jointOf(const RobotTurn& turn, float armature)
{
    const std::string range = turn.range.bounded()
                                  ? fmt::format(" range=\"{:.6g} {:.6g}\"", turn.range.lowest, turn.range.highest)
                                  : "";
    const std::string own = armature > 0.0f ? fmt::format(" armature=\"{:.6g}\"", armature) : "";
    return fmt::format("<joint name=\"{}\" type=\"hinge\" axis=\"{}\" limited=\"{}\"{}{}/>", escapedMarkup(turn.name),
                       numbersOf(turn.axis), turn.range.bounded(), range, own);
}

std::string jointsOf(const RobotLink& link, const std::string& indent)
{
    if (link.parent < 0) return indent + "<freejoint/>\n";
    if (link.isBall) return fmt::format("{}<joint name=\"{}\" type=\"ball\"/>\n", indent, escapedMarkup(link.name));
    std::string text;
    const float armature = link.turns.size() > 1 ? hingeInertia(link) : 0.0f;
    for (const RobotTurn& turn : link.turns) text += indent + jointOf(turn, armature) + "\n";
    return text;
}

std::string geomOf(const RobotLink& link)
{
    const Vector3f one = link.ends[0] - link.origin, other = link.ends[1] - link.origin;
    if ((other - one).norm() < 1e-4f)
        return fmt::format("<geom type=\"sphere\" pos=\"{}\" size=\"{:.6g}\"/>", numbersOf(0.5f * (one + other)),
                           link.radius);
    return fmt::format("<geom type=\"capsule\" fromto=\"{} {}\" size=\"{:.6g}\"/>", numbersOf(one), numbersOf(other),
                       link.radius);
}

std::string bodyOf(const Robot& robot, uint32_t index, const std::string& indent)
{
    const RobotLink& link = robot.links[index];
    const Eigen::Matrix3f& i = link.inertia;
    const Vector3f from = link.parent < 0 ? Vector3f(0, 0, 0) : robot.links[static_cast<size_t>(link.parent)].origin;
    const std::string within = indent + "  ";
    std::string text = fmt::format("{}<body name=\"{}\" pos=\"{}\">\n", indent, escapedMarkup(link.name),
                                   numbersOf(link.origin - from));
    text += fmt::format(
        "{}<inertial pos=\"{}\" mass=\"{:.6g}\" fullinertia=\"{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\"/>\n", within,
        numbersOf(link.centre - link.origin), link.mass, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    text += jointsOf(link, within) + within + geomOf(link) + "\n";
    for (uint32_t k = 0; k < robot.links.size(); ++k)
        if (robot.links[k].parent == static_cast<int32_t>(index)) text += bodyOf(robot, k, within);
    return text + indent + "</body>\n";
}

}  // namespace

std::string mjcfOf(const Robot& robot)
{
    std::string text = fmt::format(
        "<mujoco model=\"{}\">\n  <compiler angle=\"radian\" autolimits=\"false\"/>\n  <worldbody>\n",
        escapedMarkup(robot.name));
    for (uint32_t k = 0; k < robot.links.size(); ++k)
        if (robot.links[k].parent < 0) text += bodyOf(robot, k, "    ");
    text += "  </worldbody>\n  <contact>\n";
    for (const auto& [one, other] : robot.apart)
        text += fmt::format("    <exclude body1=\"{}\" body2=\"{}\"/>\n", escapedMarkup(robot.links[one].name),
                            escapedMarkup(robot.links[other].name));
    return text + "  </contact>\n</mujoco>\n";
}

}  // namespace knuckle
