#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace knuckle {

/// The shortest decimals that read back as the same float.
inline std::string vectorText(const Eigen::Vector3f& v)
{
    return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
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
