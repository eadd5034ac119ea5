#pragma once

#include <map>
#include <string>
#include <vector>

namespace knuckle {

/// A BVH file in the only form that assimp reads.
struct PreparedBvh {
    std::string text;                              ///< Keywords in assimp's spelling, one-word names, one root.
    std::map<std::string, std::string> originals;  ///< Names that were changed: the file's, by the new one.
    std::vector<std::string> notes;
};

/// From several roots, takes the requested hierarchy and its columns of the motion; hierarchies are named as in other
/// files: a second "Hips" is "Hips#2". Text that is not BVH is returned unchanged, for assimp to refuse.
/// @param skeleton ModelPick::skeleton. @throws SkeletonError if there are several roots and it names none of them.
PreparedBvh prepareBvh(std::string text, const std::string& skeleton);

}  // namespace knuckle
