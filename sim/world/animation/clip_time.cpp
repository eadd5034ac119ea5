#include "sim/world/animation/clip_time.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

namespace {

/// @param valueAt of a key of the clip.
template <typename Value, typename ValueAt>
Value spline(uint32_t keyCount, const ClipTime& at, const ValueAt& valueAt)
{
    const uint32_t k = at.key, next = std::min(k + 1, keyCount - 1);
    const Value b = valueAt(k), c = valueAt(next);
    const Value a = k > 0 ? Value(valueAt(k - 1)) : Value(2.0f * b - c);
    const Value d = next + 1 < keyCount ? Value(valueAt(next + 1)) : Value(2.0f * c - b);
    const float t = at.part;
    return b + 0.5f * t * ((c - a) + t * ((2.0f * a - 5.0f * b + 4.0f * c - d) + t * (3.0f * (b - c) + d - a)));
}

}  // namespace

ClipTime clipTime(const BodyClip& clip, const ClipPlay& play, double time)
{
    const double last = clip.keyCount() - 1;
    double key = (play.start + play.speed * std::max(time - play.at, 0.0)) * clip.rate;
    ClipTime at;
    if (last <= 0.0) return at;
    if (play.loop) {
        at.rounds = static_cast<uint32_t>(key / last);
        key -= at.rounds * last;
    }
    key = std::clamp(key, 0.0, last);
    at.key = static_cast<uint32_t>(std::min(std::floor(key), last - 1.0));
    at.part = static_cast<float>(key - at.key);
    return at;
}

Vector3f sampleRoot(const BodyClip& clip, const ClipTime& at)
{
    return spline<Vector3f>(clip.keyCount(), at, [&](uint32_t key) { return clip.roots[key]; });
}

Quaternionf sampleTurn(const BodyClip& clip, const ClipTime& at, uint32_t body)
{
    const Eigen::Vector4f turn = spline<Eigen::Vector4f>(clip.keyCount(), at, [&](uint32_t key) {
        return Eigen::Vector4f(clip.turns[size_t{key} * clip.bodyCount + body].coeffs());
    });
    return Quaternionf(turn).normalized();
}

Quaternionf mixed(const Quaternionf& from, const Quaternionf& to, float part)
{
    const float side = from.dot(to) < 0.0f ? -1.0f : 1.0f;
    return Quaternionf((1.0f - part) * side * from.coeffs() + part * to.coeffs()).normalized();
}

}  // namespace knuckle
