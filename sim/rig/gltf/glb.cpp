#include "sim/rig/gltf/glb.h"

#include "sim/rig/gltf/gltf_clips.h"
#include "sim/rig/gltf/gltf_mesh.h"

namespace knuckle {

namespace {

/// Adds the bones of a model. A skin wants one root, so several roots get a node above them. @returns the node of the
/// first bone; the others follow.
size_t addBones(GltfFile& file, const Model& model, GltfJson& roots)
{
    const size_t first = file.count("nodes");
    GltfJson own = GltfJson::array();
    std::vector<Eigen::Matrix4f> rest;
    for (const Bone& bone : model.bones) rest.push_back(bone.restPose);
    for (size_t b = 0; b < model.bones.size(); ++b) {
        const LocalPose pose = localPose(model, rest, b);
        GltfJson node{{"name", model.bones[b].name},
                      {"translation", gltfArray(pose.translation)},
                      {"rotation", gltfArray(pose.rotation.coeffs())}};
        GltfJson children = GltfJson::array();
        for (size_t c = b + 1; c < model.bones.size(); ++c)
            if (model.bones[c].parent == static_cast<int32_t>(b)) children.push_back(first + c);
        if (!children.empty()) node["children"] = std::move(children);
        if (model.bones[b].parent < 0) own.push_back(first + b);
        file.append("nodes", std::move(node));
    }
    if (own.size() > 1) {
        GltfJson above{{"name", model.name + " root"}, {"children", own}};
        own = GltfJson::array({file.append("nodes", std::move(above))});
    }
    for (const GltfJson& root : own) roots.push_back(root);
    return first;
}

}  // namespace

std::string toGlb(std::span<const Model> models, const GlbOptions& options)
{
    GltfFile file;
    GltfJson roots = GltfJson::array();
    if (options.apart) file.root["asset"]["generator"] = GLB_OF_OBJECTS;
    file.root["scene"] = 0;
    file.root["scenes"] = GltfJson::array({GltfJson::object()});
    for (const Model& model : models) {
        const size_t firstBone = addBones(file, model, roots);
        if (!model.triangles.empty()) roots.push_back(addMesh(file, model, firstBone, options));
        for (const Clip& clip : model.clips) addClip(file, model, clip, firstBone, options);
    }
    file.root["scenes"][0]["nodes"] = std::move(roots);
    return file.bytes();
}

}  // namespace knuckle
