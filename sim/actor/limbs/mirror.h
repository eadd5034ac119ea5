#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/anatomy/mirror_plane.h"
#include "sim/actor/mesh/voxelize.h"

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

/// Where the solid is its own image within half a particle's diameter, gives the side of the plane that looks down its
/// normal the images of the other side's particles, and their bones.
/// @param bones per particle.
/// @param parents of bones: what lies on the plane belongs to a bone on it where this is next to it. What stands
/// between two bones that are images of each other is left out elsewhere.
void mirrorParticles(const Solid& solid, const Mirror& mirror, const std::vector<int32_t>& parents, Voxels& voxels,
                     std::vector<uint32_t>& bones);

}  // namespace knuckle
