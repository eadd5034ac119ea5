#pragma once

#include <random>

namespace knuckle {

/// Uniform in 0 ... 1, made from the generator's raw numbers, which are the same everywhere, unlike the standard
/// library's distributions.
inline float uniformFraction(std::mt19937& random)
{
    return static_cast<float>(static_cast<double>(random()) / 4294967296.0);
}

}  // namespace knuckle
