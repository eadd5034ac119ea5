#include "app/json/joint_limits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/json/fields.h"
#include "sim/base/angles.h"

namespace knuckle {

namespace {

/// Rounded to a ten-thousandth, the precision of the input.
double roundedDegrees(float radians)
{
    return std::round(degreesOf(radians) * 1e4) / 1e4;
}

/// The ranges of the fields.
constexpr std::array RANGES{std::pair{"twist", &JointLimits::twist}, std::pair{"bend", &JointLimits::bend},
                            std::pair{"secondBend", &JointLimits::secondBend}};

}  // namespace

JointLimits readLimits(const Json& json)
{
    JointLimits limits;
    limits.swing = radiansOf(json["swing"]);
    readValue(json["cone"], limits.cone);
    for (const auto& [key, range] : RANGES) limits.*range = {radiansOf(json[key][0]), radiansOf(json[key][1])};
    limits.stiffness = readUnlessZero(json["stiffness"]);
    return limits;
}

JointStrength readStrength(const Json& json)
{
    JointStrength strength{readUnlessZero(json["tearForce"]), readUnlessZero(json["tearTorque"])};
    if (json.contains("releaseTime")) strength.time = readUnlessZero(json["releaseTime"]);
    return strength;
}

void requireLimits(const std::string& path, const std::string& pointer, const JointLimits& limits,
                   const std::vector<JointType>& types)
{
    std::vector<std::string> words;
    for (const JointType type : types) words.push_back(wordOf(type));
    for (const std::string& name : limits.misplacedIn(types.front())) {
        const bool everywhere = std::ranges::all_of(types, [&](JointType type) {
            const std::vector<std::string> misplaced = limits.misplacedIn(type);
            return std::ranges::find(misplaced, name) != misplaced.end();
        });
        if (!everywhere) continue;
        failAt(path, pointer + "/" + name,
               fmt::format("is no limit of a {} joint; a ball has `swing`, `cone` and `twist`, a hinge `bend`, a "
                           "universal joint `bend` and `secondBend`",
                           fmt::join(words, " or ")));
    }
}

Json writeLimits(const JointLimits& limits)
{
    Json json = {{"swing", roundedDegrees(limits.swing)}, {"cone", writeValue(limits.cone)}};
    for (const auto& [key, range] : RANGES)
        json[key] = {roundedDegrees((limits.*range).lowest), roundedDegrees((limits.*range).highest)};
    json["stiffness"] = std::isinf(limits.stiffness) ? 0.0f : limits.stiffness;
    return json;
}

}  // namespace knuckle
