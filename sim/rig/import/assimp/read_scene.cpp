#include "sim/rig/import/assimp/read_scene.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <new>
#include <utility>

#include "sim/base/errors.h"
#include "sim/base/lowercase.h"
#include "sim/rig/import/assimp/clips.h"
#include "sim/rig/import/assimp/looks/surface.h"
#include "sim/rig/import/assimp/meshes.h"
#include "sim/rig/import/assimp/nodes/apart.h"
#include "sim/rig/import/assimp/nodes/bind_pose.h"
#include "sim/rig/import/assimp/nodes/bones.h"
#include "sim/rig/import/assimp/nodes/moved_nodes.h"
#include "sim/rig/import/assimp/nodes/node_table.h"
#include "sim/rig/import/assimp/nodes/skeletons.h"
#include "sim/rig/import/assimp/read_file.h"
#include "sim/rig/import/assimp/split_parts.h"
#include "sim/rig/import/file_check.h"
#include "sim/rig/import/valid_text.h"

namespace knuckle {

namespace {

/// An edge without its own normals is drawn sharp above this angle [degrees].
constexpr float CREASE = 60.0f;

}  // namespace

Model readScene(const std::string& path, bool surface, const ModelPick& pick)
{
    checkParts(path);
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    // Importers of some games' formats look for further files beside the given one. Only those for drawing are needed.
    const int looks = surface ? 0 : aiComponent_TEXTURES | aiComponent_MATERIALS;
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, looks | aiComponent_LIGHTS | aiComponent_CAMERAS);
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, CREASE);
    const unsigned normals = surface ? unsigned{aiProcess_GenSmoothNormals} : 0u;
    FileNames names;
    const aiScene* scene = readFile(
        importer, path, aiProcess_Triangulate | aiProcess_PopulateArmatureData | aiProcess_GlobalScale | normals, pick,
        names);
    if (scene == nullptr || scene->mRootNode == nullptr) {
        const std::string reason = importer.GetErrorString();
        if (reason.find("bad_alloc") != std::string::npos) {
            throw std::bad_alloc();  // assimp made it a message; running out of memory has its own
        }
        std::string line = reason.substr(0, reason.find('\n'));
        // This prefix names a line of data in memory, which is not one of the file.
        constexpr std::string_view IN_MEMORY = "$$$___magic___$$$";
        if (line.starts_with(IN_MEMORY) && line.find(" - ") != std::string::npos) line.erase(0, line.find(" - ") + 3);
        line.erase(line.find_last_not_of(". ") + 1);
        throw InputError(unreadableBecause(line));
    }
    Model model;
    model.name = std::filesystem::path(path).stem().string();
    NodeTable table = listNodes(*scene);
    table.originals = std::move(names.originals);
    // Assimp turns an MD5 clip into a mesh of needles.
    const bool isClip = lowercase(std::filesystem::path(path).extension().string()) == ".md5anim";
    table.isBare = scene->mNumMeshes == 0 || isClip;
    table.isOfParts = !pick.split;
    const bool isDrawn = surface && !table.isBare;
    if (!isDrawn) model.notes = std::move(names.notes);
    findBoneNodes(*scene, table);
    takeBindPose(*scene, table, model.notes);
    convertBones(pickSkeleton(*scene, pick, table, model.notes), table, model);
    if (table.boneNodes.empty() && !table.isBare && !model.bones.empty())
        model.notes.push_back(
            fmt::format("No mesh has a skeleton: of what {} {} bone{} made.",
                        movedNodes(*scene, table).empty() ? "is called after parts of a body" : "clips move",
                        model.bones.size(), model.bones.size() == 1 ? " was" : "s were"));
    if (pick.skeleton != ALL_SKELETONS) leaveApart(*scene, table, model.notes);
    convertMeshes(*scene, table, model);
    if (isDrawn) {
        convertSurface(*scene, table, path, model);
        noteMissingMaterials(path, model.surface);
        for (const auto* notes : {&names.notes, &names.missing})
            model.surface.missing.insert(model.surface.missing.end(), notes->begin(), notes->end());
    }
    convertClips(*scene, table, model);
    if (pick.split) splitIntoParts(*scene, table, model);
    return model;
}

}  // namespace knuckle
