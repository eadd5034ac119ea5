#include "sim/rig/joints/lasting_turns.h"

#include <algorithm>
#include <cmath>

#include "sim/base/angles.h"

namespace knuckle {

namespace {

constexpr float MOMENT = 0.1f;  // [s]
constexpr float HELD = 1e-4f;   // least change of a turn that counts as held [rad]

float beyond(const TurnRange& range, float angle)
{
    return angle > range.highest ? angle - range.highest : std::min(angle - range.lowest, 0.0f);
}

/// Marks keys beyond the limits for a moment or by far.
/// @param off per key how far, below 0 at a range's lower end [rad].
void markWild(const std::vector<float>& off, float rate, const Leeway& leeway, std::vector<bool>& wild, float& leftOut)
{
    const auto isBeyond = [&](size_t key, float side) { return key < off.size() && side * off[key] > leeway.moment; };
    for (size_t key = 0; key < off.size();) {
        const float side = off[key] < 0.0f ? -1.0f : 1.0f;
        size_t end = key;
        float most = 0.0f;
        for (; isBeyond(end, side); ++end) most = std::max(most, side * off[end]);
        const bool lasts = off.size() == 1 || static_cast<float>(end - key) >= MOMENT * rate;
        if (end > key && (!lasts || most > leeway.lasting)) {
            std::fill(wild.begin() + static_cast<std::ptrdiff_t>(key), wild.begin() + static_cast<std::ptrdiff_t>(end),
                      true);
            leftOut = std::max(leftOut, most);
        }
        key = std::max(end, key + 1);
    }
}

/// A range less the spare at its ends, at least its middle.
TurnRange inner(const TurnRange& range)
{
    if (!range.bounded()) return range;
    const float middle = 0.5f * (range.lowest + range.highest);
    return {std::min(range.lowest + LIMIT_SPARE, middle), std::max(range.highest - LIMIT_SPARE, middle)};
}

Turns clamped(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns)
{
    const bool isBall = type == JointType::Ball;
    const TurnRange twist = inner(isBall ? limits.twist : limits.bend);
    const bool swings = !isBall || limits.swing >= HALF_TURN;
    const float swing = swings ? HALF_TURN : std::max(limits.swing - LIMIT_SPARE, 0.5f * limits.swing);
    TurnReader reader(limits, type, axis);
    Turns held;
    for (const Quaternionf& turn : turns) {
        TurnParts parts = reader.read(turn);
        const bool fits = parts.swing <= swing + HELD && std::abs(beyond(twist, parts.twist)) <= HELD;
        parts.swing = std::min(parts.swing, swing);
        parts.twist = std::clamp(parts.twist, twist.lowest, twist.highest);
        held.push_back(fits ? turn : reader.turnOf(parts));
    }
    return held;
}

/// Per key, the number of keys to the nearest held one, at most `most`.
std::vector<int> keysToHeld(const Turns& turns, const Turns& held, int most)
{
    std::vector<int> away(turns.size(), most);
    const auto last = static_cast<int>(turns.size()) - 1;
    for (int key = 0; key <= last; ++key) {
        if (turns[key].angularDistance(held[key]) <= HELD) continue;
        for (int k = std::max(key - most, 0); k <= std::min(key + most, last); ++k)
            away[k] = std::min(away[k], std::abs(k - key));
    }
    return away;
}

/// The mean of a key and those around it, weighted less with their distance.
Quaternionf meanAround(const Turns& turns, int key, int reach)
{
    const Quaternionf& middle = turns[key];
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();
    for (int k = key - reach; k <= key + reach; ++k) {
        const auto weight = static_cast<float>(reach + 1 - std::abs(k - key));
        sum += (turns[k].dot(middle) < 0.0f ? -weight : weight) * turns[k].coeffs();
    }
    return Quaternionf(Eigen::Vector4f(sum.normalized()));
}

}  // namespace

LastingTurns lastingTurns(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns,
                          float rate, const Leeway& leeway)
{
    TurnReader reader(limits, type, axis);
    const TurnRange& range = type == JointType::Ball ? limits.twist : limits.bend;
    std::vector<float> swings, twists;
    for (const Quaternionf& turn : turns) {
        const TurnParts parts = reader.read(turn);
        swings.push_back(type == JointType::Ball ? std::max(parts.swing - limits.swing, 0.0f) : 0.0f);
        twists.push_back(parts.isTwistSure ? beyond(range, parts.twist) : 0.0f);
    }
    LastingTurns lasting;
    std::vector<bool> wild(turns.size(), false);
    markWild(swings, rate, leeway, wild, lasting.leftOut);
    markWild(twists, rate, leeway, wild, lasting.leftOut);
    bool goesOn = false;
    for (size_t key = 0; key < turns.size(); ++key) {
        if (!wild[key] && !goesOn) lasting.parts.emplace_back();
        goesOn = !wild[key];
        if (goesOn) lasting.parts.back().push_back(turns[key]);
    }
    return lasting;
}

Turns heldTurns(const JointLimits& limits, JointType type, const Vector3f& axis, const Turns& turns, float rate)
{
    const Turns held = clamped(limits, type, axis, turns);
    const int most = std::max(1, static_cast<int>(std::ceil(MOMENT * rate)));
    const std::vector<int> away = keysToHeld(turns, held, most);
    const auto last = static_cast<int>(turns.size()) - 1;
    Turns smooth = held;
    for (int key = 0; key <= last; ++key) {
        const int reach = std::min({most, key, last - key});
        if (away[key] == most || reach == 0) continue;
        const float part = 1.0f - static_cast<float>(away[key]) / static_cast<float>(most);
        smooth[key] = held[key].slerp(part, meanAround(held, key, reach));
    }
    return clamped(limits, type, axis, smooth);
}

}  // namespace knuckle
