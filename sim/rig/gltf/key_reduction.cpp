#include "sim/rig/gltf/key_reduction.h"

namespace knuckle {

namespace {

float errorOf(const Eigen::Vector3f& a, const Eigen::Vector3f& b, float part, const Eigen::Vector3f& truth)
{
    return (a + part * (b - a) - truth).norm();
}

float errorOf(const Eigen::Quaternionf& a, const Eigen::Quaternionf& b, float part, const Eigen::Quaternionf& truth)
{
    return a.slerp(part, b).angularDistance(truth);
}

/// Whether a straight line between two keys is good enough for all between.
template <typename Value>
bool spans(std::span<const float> times, std::span<const Value> values, size_t from, size_t to, float tolerance)
{
    for (size_t k = from + 1; k < to; ++k) {
        const float part = (times[k] - times[from]) / (times[to] - times[from]);
        if (errorOf(values[from], values[to], part, values[k]) > tolerance) return false;
    }
    return true;
}

/// Makes each line as long as possible: doubles it while it fits, then finds the end by bisection.
template <typename Value>
std::vector<size_t> reduced(std::span<const float> times, std::span<const Value> values, float tolerance)
{
    std::vector<size_t> keys{0};
    while (keys.back() + 1 < times.size()) {
        const size_t from = keys.back(), end = times.size() - 1;
        size_t good = from + 1, bad = end + 1;
        for (size_t step = 2; good < end && bad > end; step *= 2) {
            const size_t to = std::min(from + step, end);
            (spans(times, values, from, to, tolerance) ? good : bad) = to;
        }
        while (bad <= end && bad - good > 1) {
            const size_t middle = (good + bad) / 2;
            (spans(times, values, from, middle, tolerance) ? good : bad) = middle;
        }
        keys.push_back(good);
    }
    return keys;
}

}  // namespace

std::vector<size_t> keysOf(std::span<const float> times, std::span<const Eigen::Vector3f> values, float tolerance)
{
    return reduced(times, values, tolerance);
}

std::vector<size_t> keysOf(std::span<const float> times, std::span<const Eigen::Quaternionf> values, float tolerance)
{
    return reduced(times, values, tolerance);
}

}  // namespace knuckle
