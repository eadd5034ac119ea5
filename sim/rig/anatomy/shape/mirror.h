#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/shape/mirror_plane.h"

namespace knuckle {

/// A skeleton's plane of symmetry, and the image of each bone in it.
struct Mirror {
    MirrorPlane plane;
    std::vector<uint32_t> images;  ///< Per bone: itself if it lies on the plane, NO_INDEX if it has none.

    /// The axis that the plane is perpendicular to; -1 if none.
    int axis() const;
    /// Removes images between bones whose limbs are not each other's images: options want one side to differ.
    void keepAlike(std::span<const BoneAnatomy> anatomy);
};

/// None for a skeleton without symmetry.
std::optional<Mirror> findMirror(const BoneTree& tree);

}  // namespace knuckle
