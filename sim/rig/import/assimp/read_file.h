#pragma once

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

#include "sim/rig/model_source.h"

namespace Assimp {
class Importer;
}

namespace knuckle {

/// Facts about a file that was changed for assimp.
struct FileNames {
    std::map<std::string, std::string> originals;  ///< The file's names, by those that replace them.
    std::vector<std::string> notes, missing;       ///< For the model; for its surface.
};

/// Reads a file with assimp. @throws SkeletonError as pickSkeleton().
const aiScene* readFile(Assimp::Importer& importer, const std::string& path, unsigned flags, const ModelPick& pick,
                        FileNames& names);

}  // namespace knuckle
