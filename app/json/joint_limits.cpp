#include "app/json/joint_limits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/json/fields.h"
#include "sim/base/angles.h"

namespace knuckle {

namespace {

float inSinglePrecision(double degrees)
{
    return radiansOf(static_cast<float>(degrees));
}

/// Unlike the other one it reaches every angle.
float inDoublePrecision(double degrees)
{
    return static_cast<float>(degrees / 180.0 * std::numbers::pi);
}

/// With four decimals, or as many as give the same angle again.
double writtenDegrees(float radians)
{
    constexpr double MOST = 1e12;
    const double exact = degreesOf(radians);
    for (double scale = 1e4; scale < MOST; scale *= 10.0)
        if (const double rounded = std::round(exact * scale) / scale; inDoublePrecision(rounded) == radians)
            return rounded;
    return exact;
}

/// The ranges of the fields.
constexpr std::array RANGES{std::pair{"twist", &JointLimits::twist}, std::pair{"bend", &JointLimits::bend},
                            std::pair{"secondBend", &JointLimits::secondBend}};

JointLimits limitsIn(const Json& json, float (*radians)(double))
{
    JointLimits limits;
    limits.swing = radians(json["swing"]);
    readValue(json["cone"], limits.cone);
    for (const auto& [key, range] : RANGES) limits.*range = {radians(json[key][0]), radians(json[key][1])};
    limits.stiffness = readUnlessZero(json["stiffness"]);
    return limits;
}

}  // namespace

JointLimits readLimits(const Json& json)
{
    return limitsIn(json, inSinglePrecision);
}

JointLimits readWrittenLimits(const Json& json)
{
    return limitsIn(json, inDoublePrecision);
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
    Json json = {{"swing", writtenDegrees(limits.swing)}, {"cone", writeValue(limits.cone)}};
    for (const auto& [key, range] : RANGES)
        json[key] = {writtenDegrees((limits.*range).lowest), writtenDegrees((limits.*range).highest)};
    json["stiffness"] = std::isinf(limits.stiffness) ? 0.0f : limits.stiffness;
    return json;
}

}  // namespace knuckle
