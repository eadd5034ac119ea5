#pragma once

#include <map>
#include <string>
#include <vector>

namespace knuckle {

/// A BVH file in the one form that assimp reads.
struct PreparedBvh {
    std::string text;                              ///< Keywords in their letters, a name one word, one root.
    std::map<std::string, std::string> originals;  ///< Names that were changed: the file's, by the new one.
    std::vector<std::string> notes;
};

/// Of several roots takes the hierarchy, and the columns of the motion, of the one that is asked for; they are named as
/// those of other files: a second "Hips" is "Hips#2". What is no BVH comes back as it is, for assimp to refuse.
/// @param skeleton ModelPick::skeleton. @throws SkeletonError where several roots are there and it names none of them.
PreparedBvh prepareBvh(std::string text, const std::string& skeleton);

}  // namespace knuckle
