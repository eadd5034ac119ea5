#pragma once

#include "render/compare/flip/flip_colors.h"
#include "render/compare/flip/flip_filters.h"

namespace knuckle {

/// A picture's part in linear light, three planes of red, green and blue, 0 to 1.
using LightTile = std::array<Plane, 3>;

/// FLIP on a part of two pictures. Keeps its memory from call to call; each thread needs one of its own.
class FlipTile {
public:
    explicit FlipTile(const FlipFilters& filters);

    /// @param a, b of one size, with `reach` pixels more than the part has on all sides, which are overwritten.
    /// @returns the errors of the part, 0 to 1.
    const Plane& errors(LightTile& a, LightTile& b);

private:
    /// What is compared of one picture.
    struct Seen {
        LightTile colors;   ///< As the eye takes them in, in CIELAB with the Hunt effect.
        Plane edge, point;  ///< How strong edges and points are there.
    };
    void see(LightTile& light, Seen& seen);
    void filterColors(const LightTile& opponent, LightTile& colors);
    void findFeatures(const Plane& brightness, const std::vector<float>& along, const Plane& smoothed, Plane& strength);

    const FlipFilters& filters_;
    float largestDistance_;  ///< Between green and blue, raised to COLOR_EXPONENT.
    Seen a_, b_;
    Plane errors_, rows_, smoothed_, across_;
};

}  // namespace knuckle
