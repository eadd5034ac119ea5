#include "render/view/camera_shake.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/base/angles.h"

namespace knuckle {

namespace {

/// A wave of a hand's tremor: multiples of the shake's frequency, and shares of its amplitude that add up to 1.
struct Wave {
    double frequency, share;
};

/// No multiple is a simple fraction of another, so that a minute passes before it nearly repeats.
constexpr std::array<Wave, 5> WAVES{{{0.37, 0.34}, {0.71, 0.27}, {1.0, 0.19}, {1.83, 0.13}, {3.17, 0.07}}};
constexpr float ROLL_SHARE = 0.5f;

}  // namespace

Eigen::Vector3f shakeAt(const CameraShake& shake, double time)
{
    std::minstd_rand random(shake.seed * 48u + 7u);  // its numbers are the same with every library
    const auto chance = [&] { return static_cast<double>(random() - 1) / 2147483646.0; };
    Eigen::Vector3f angles;
    for (int axis = 0; axis < 3; ++axis) {
        double sum = 0.0;
        for (const Wave& wave : WAVES) {
            const double pace = wave.frequency * (0.9 + 0.2 * chance()), phase = chance();
            sum += wave.share * std::sin(2.0 * std::numbers::pi * (pace * shake.frequency * time + phase));
        }
        angles[axis] = static_cast<float>(sum) * shake.amplitude * DEGREE;
    }
    angles[2] *= ROLL_SHARE;
    return angles;
}

}  // namespace knuckle
