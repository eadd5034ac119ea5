#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

namespace knuckle {

/// The shortest decimals that read back as the same float: "-0" would be the integer 0.
inline std::string numberText(float value)
{
    return value == 0.0f && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

inline std::string vectorText(const Eigen::Vector3f& v)
{
    return fmt::format("[{}, {}, {}]", numberText(v.x()), numberText(v.y()), numberText(v.z()));
}

/// `"name": [` with one element per line, that of an object with two more blanks before each.
template <typename T, typename Text>
std::string listText(const char* name, const std::vector<T>& elements, Text&& text, const std::string& indent = "  ")
{
    std::vector<std::string> lines;
    for (const T& element : elements) lines.push_back(indent + "  " + text(element));
    return fmt::format("\n{}\"{}\": [{}{}{}]", indent, name, lines.empty() ? "" : "\n", fmt::join(lines, ",\n"),
                       lines.empty() ? "" : "\n" + indent);
}

}  // namespace knuckle
