#pragma once

#include "sim/world/world.h"

namespace knuckle {

/// Most that a particle's pull by its clusters grows with its displacement, per mass, in a soft body [1/s2].
double steepestPull(const World& world, const SoftBody& soft);

/// Iterations a substep in which all soft bodies of a world become as stiff as they shall be, or the most there are.
uint32_t softIterations(const World& world);

/// The Young's modulus that a soft body shows with these [Pa]: its material's, or what the most allow.
float shownStiffness(const World& world, const SoftBody& soft);

/// How n iterations of Chebyshev's leave of the error of any strain, however stiff, at most MOST_LEFT: the eigenvalues
/// that they take for the least are at least `least` of the largest. Of smooth strains nothing is left as far as that
/// allows: `cosine` is that of the root that shall be at 1.
struct Chebyshev {
    explicit Chebyshev(uint32_t n);
    /// The largest steepness (the largest eigenvalue less 1) at which the smallest root is at 1.
    double followed() const;
    float least, cosine;
};

}  // namespace knuckle
