#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/shape/mirror_plane.h"

namespace knuckle {

/// A skeleton's plane of symmetry, and which bone is which one's image in it.
struct Mirror {
    MirrorPlane plane;
    std::vector<uint32_t> images;  ///< Per bone: itself if it lies on the plane, NO_INDEX if it has none.

    /// The axis that the plane is across, where it is one; -1.
    int axis() const;
    /// Bones whose limbs are not each other's images have none: somebody wants one side otherwise.
    void keepAlike(std::span<const BoneAnatomy> anatomy);
};

/// None for a skeleton without symmetry.
std::optional<Mirror> findMirror(const BoneTree& tree);

}  // namespace knuckle
