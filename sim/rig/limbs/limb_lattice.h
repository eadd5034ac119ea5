#pragma once

#include <functional>
#include <vector>

#include "sim/rig/mesh/solid.h"

namespace knuckle {

/// The frame of a limb's lattice.
struct LimbFrame {
    Eigen::Vector3f head{0, 0, 0}, end{0, -1, 0};  ///< Of its bone [m].
    Eigen::Vector3f across{0, 0, 1};               ///< Unit, across the bone: the lattice's rows go across both.
    float radius = 0.0f;                           ///< The limb lies this near to its bone's line [m].
    float before = 0.0f, after = 0.0f;             ///< How far it extends beyond head and end [m].
    bool leaf = false;                             ///< Nothing hangs on its end.

    Eigen::Vector3f along() const { return (end - head).normalized(); }
    float length() const { return (end - head).norm(); }
};

/// Arrangement of particles in a slice across a limb.
struct SlicePattern {
    bool hexagonal = false;             ///< Every other row is shifted by half; else squares.
    Eigen::Vector2f shift{0.0f, 0.0f};  ///< Of the pattern from the bone, in spacings along and across its rows.
};

/// Rings of 1 + 6 and of 3, squares of 3 x 3, 2 x 2 and 3 x 2.
extern const std::vector<SlicePattern> SLICE_PATTERNS;

/// Places in slices across the bone, one slice at its head and one at its end, for which `belongs` holds. Each stands
/// for a cube of `diameter`: in slices that are closer than that, places are further apart.
std::vector<Eigen::Vector3f> limbPlaces(const LimbFrame& frame, const SlicePattern& pattern, float diameter,
                                        const std::function<bool(const Eigen::Vector3f&)>& belongs);

/// How far particles miss a surface: root mean square of the nearest particle's distance less half a diameter, over
/// points of the surface [diameters].
float surfaceError(const std::vector<Eigen::Vector3f>& particles, const std::vector<Eigen::Vector3f>& surface,
                   float diameter);

}  // namespace knuckle
