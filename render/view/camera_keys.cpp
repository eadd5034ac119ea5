#include "render/view/camera_keys.h"

#include <algorithm>

namespace knuckle {

namespace {

using Values = Eigen::Array<double, 10, 1>;

Values valuesOf(const CameraKey& key)
{
    Values values;
    values << key.position.cast<double>().array(), key.target.cast<double>().array(), key.fieldOfView, key.roll,
        key.aperture, key.focus;
    return values;
}

/// Mean speed from key k to the next one.
Values slope(std::span<const CameraKey> keys, size_t k)
{
    return (valuesOf(keys[k + 1]) - valuesOf(keys[k])) / (keys[k + 1].time - keys[k].time);
}

/// Speed of the smooth curve at key k: none at the ends and where a value turns back, else the weighted harmonic mean
/// of the slopes beside it, which keeps the curve between its keys.
Values speedAt(std::span<const CameraKey> keys, size_t k)
{
    if (k == 0 || k + 1 == keys.size()) return Values::Zero();
    const double before = keys[k].time - keys[k - 1].time, after = keys[k + 1].time - keys[k].time;
    const Values a = slope(keys, k - 1), b = slope(keys, k);
    const double wa = 2.0 * after + before, wb = after + 2.0 * before;
    const Values mean = (wa + wb) * a * b / (wa * b + wb * a);
    return (a * b > 0.0).select(mean, Values::Zero());
}

/// The share of the way to the next key that is done at the share `t` of the time.
double eased(Easing easing, double t)
{
    switch (easing) {
        case Easing::EaseIn: return t * t;
        case Easing::EaseOut: return t * (2.0 - t);
        case Easing::EaseInOut: return t * t * (3.0 - 2.0 * t);
        case Easing::Hold: return t < 1.0 ? 0.0 : 1.0;
        default: return t;
    }
}

Values valuesAt(std::span<const CameraKey> keys, double time)
{
    if (time <= keys.front().time) return valuesOf(keys.front());
    if (time >= keys.back().time) return valuesOf(keys.back());
    size_t k = 0;
    while (keys[k + 1].time <= time) ++k;
    const Values a = valuesOf(keys[k]), b = valuesOf(keys[k + 1]);
    const double span = keys[k + 1].time - keys[k].time, t = (time - keys[k].time) / span, s = 1.0 - t;
    if (keys[k].easing != Easing::Smooth) return a + eased(keys[k].easing, t) * (b - a);
    return s * s * (1.0 + 2.0 * t) * a + t * t * (1.0 + 2.0 * s) * b +
           span * s * t * (s * speedAt(keys, k) - t * speedAt(keys, k + 1));
}

}  // namespace

CameraPose poseAt(std::span<const CameraKey> keys, double time)
{
    const Eigen::Array<float, 10, 1> values = valuesAt(keys, time).cast<float>();
    return {values.segment<3>(0), values.segment<3>(3), values[6], values[7], values[8], values[9]};
}

}  // namespace knuckle
