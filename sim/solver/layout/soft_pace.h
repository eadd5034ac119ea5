#pragma once

#include "sim/world/world.h"

namespace knuckle {

/// How fast the iterations of a soft body converge, and what they can show of its material.
struct SoftPace {
    double steepest = 0.0;    ///< Most that the pull on a particle grows with its displacement, per mass [1/s2].
    uint32_t iterations = 1;  ///< A substep; MOST_SOFT_ITERATIONS at most, or those of the settings.
    float stiffness = 0.0f;   ///< Its material's [Pa], or less: the most that these iterations can follow.
    float damping = 0.0f;     ///< Its material's [s], or less: it goes first, as far as four substeps.
};

inline constexpr uint32_t MOST_SOFT_ITERATIONS = 16;

SoftPace softPace(const World& world, const SoftBody& soft);

/// Chebyshev's n iterations for eigenvalues from 1 to 1 + a steepness.
struct Chebyshev {
    explicit Chebyshev(uint32_t n);
    /// The largest steepness at which nothing is left of the error of smooth strains, whose eigenvalue is 1.
    double followed() const;

    double least;   ///< Of the largest eigenvalue: what they take at least for the smallest, to overshoot little.
    double cosine;  ///< That of the smallest root.
};

}  // namespace knuckle
