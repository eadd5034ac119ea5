#include "sim/actor/import/import_scene.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <new>
#include <utility>

#include "sim/actor/import/file_check.h"
#include "sim/actor/import/lowercase.h"
#include "sim/actor/import/valid_text.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr size_t NODE_LIMIT = 100000;
constexpr size_t DEPTH_LIMIT = 1000;
/// From here on an edge without normals of its own is drawn sharp [degrees].
constexpr float CREASE = 60.0f;

// FBX keeps the up axis as metadata and the data as they are.
Eigen::Matrix4d uprightFrom(const aiScene& scene)
{
    int32_t upAxis = 1;
    if (scene.mMetaData != nullptr) {
        scene.mMetaData->Get("UpAxis", upAxis);
    }
    Eigen::Matrix4d upright = Eigen::Matrix4d::Identity();
    if (upAxis == 2) {
        upright.row(1).swap(upright.row(2));
        upright.row(2) *= -1.0;
    } else if (upAxis == 0) {
        upright.row(0).swap(upright.row(1));
        upright.row(0) *= -1.0;
    }
    return upright;
}

}  // namespace

Eigen::Matrix4d toEigen(const aiMatrix4x4& m)
{
    Eigen::Matrix4d e;
    e << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
    return e;
}

int32_t NodeTable::boneAbove(uint32_t node) const
{
    int32_t n = static_cast<int32_t>(node);
    while (n >= 0 && boneOf[n] < 0) {
        n = parents[n];
    }
    return n < 0 ? -1 : boneOf[n];
}

size_t NodeTable::sharedDepth(uint32_t a, uint32_t b) const
{
    const auto depthOf = [&](int32_t node) {
        size_t depth = 0;
        for (; node >= 0; node = parents[node]) ++depth;
        return depth;
    };
    auto x = static_cast<int32_t>(a), y = static_cast<int32_t>(b);
    size_t depthX = depthOf(x), depthY = depthOf(y);
    for (; depthX > depthY; --depthX) x = parents[x];
    for (; depthY > depthX; --depthY) y = parents[y];
    for (; x != y; --depthX) {
        x = parents[x];
        y = parents[y];
    }
    return depthX;
}

uint32_t NodeTable::commonNode(uint32_t a, uint32_t b) const
{
    // Parents come first.
    while (a != b) {
        uint32_t& lower = a > b ? a : b;
        lower = static_cast<uint32_t>(parents[lower]);
    }
    return a;
}

std::string NodeTable::nameOf(uint32_t node) const
{
    const std::string name = nodes[node]->mName.C_Str();
    const auto original = originals.find(name);
    return validText(original == originals.end() ? name : original->second);
}

NodeTable listNodes(const aiScene& scene)
{
    struct Visit {
        const aiNode* node;
        int32_t parent;
        size_t depth;
    };
    NodeTable table;
    table.upright = uprightFrom(scene);
    std::vector<Visit> stack{{scene.mRootNode, -1, 0}};
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.depth > DEPTH_LIMIT || table.nodes.size() >= NODE_LIMIT) {
            throw InputError(fmt::format("its node tree is deeper than {} or has more than {} nodes: simplify it",
                                         DEPTH_LIMIT, NODE_LIMIT));
        }
        const uint32_t index = static_cast<uint32_t>(table.nodes.size());
        const Eigen::Matrix4d local = toEigen(visit.node->mTransformation);
        table.nodes.push_back(visit.node);
        table.parents.push_back(visit.parent);
        table.locals.push_back(visit.parent < 0 ? Eigen::Matrix4d(table.upright * local) : local);
        table.indices[visit.node] = index;
        for (unsigned c = visit.node->mNumChildren; c-- > 0;) {
            stack.push_back({visit.node->mChildren[c], static_cast<int32_t>(index), visit.depth + 1});
        }
    }
    table.fbx = FbxNodes(table.nodes, table.parents);
    table.globals = table.fbx.place(table.locals, table.parents);
    for (size_t n = 0; n < table.nodes.size(); ++n)
        if (!table.globals[n].allFinite())
            throw InputError(
                fmt::format("node '{}' has a transform that is not a number", table.nodes[n]->mName.C_Str()));
    table.boneOf.assign(table.nodes.size(), -1);
    return table;
}

Model readScene(const std::string& path, bool surface, const ModelPick& pick)
{
    checkParts(path);
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    // Importers of some games' formats look for further files beside the given one. None of them is needed but for what
    // is drawn.
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
            throw std::bad_alloc();  // assimp caught it and made it a message; out of memory has a message of its own
        }
        std::string line = reason.substr(0, reason.find('\n'));
        // A line of what was read from memory is none of the file.
        constexpr std::string_view IN_MEMORY = "$$$___magic___$$$";
        if (line.starts_with(IN_MEMORY) && line.find(" - ") != std::string::npos) line.erase(0, line.find(" - ") + 3);
        line.erase(line.find_last_not_of(". ") + 1);
        throw InputError(unreadableBecause(line));
    }
    Model model;
    model.name = std::filesystem::path(path).stem().string();
    NodeTable table = listNodes(*scene);
    table.originals = std::move(names.originals);
    // Of an MD5 clip assimp makes a mesh of needles.
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
