#pragma once

#include <string>

#include "sim/rig/model.h"
#include "tests/rig/shapes.h"

namespace knuckle {

/// A chain of bones up from the ground at x, with a box on each.
inline Model chain(const std::string& name, int bones, float x)
{
    Model model;
    model.name = name + " skin";
    for (int b = 0; b < bones; ++b) {
        const float y = 0.5f * static_cast<float>(b);
        const TriangleMesh mesh = boxMesh({x, y + 0.25f, 0}, {0.1f, 0.25f, 0.1f});
        const auto first = static_cast<uint32_t>(model.vertices.size());
        for (const Triangle& t : mesh.triangles) model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        SkinWeights skin;
        skin.bones[0] = static_cast<uint32_t>(b);
        skin.weights[0] = 1.0f;
        model.vertices.insert(model.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        model.skin.resize(model.vertices.size(), skin);
        Bone bone{name + (b == 0 ? "" : std::to_string(b)), b - 1};
        bone.restPose.block<3, 1>(0, 3) = Eigen::Vector3f(x, y, 0);
        model.bones.push_back(bone);
    }
    return model;
}

/// A clip in which the last bone turns.
inline Clip clipOf(const Model& model, const std::string& name, float angle)
{
    Clip clip{name, 1.0, {0.0, 1.0}, {}};
    for (const float turn : {0.0f, angle}) {
        clip.poses.emplace_back();
        for (const Bone& bone : model.bones) clip.poses.back().push_back(bone.restPose);
        clip.poses.back().back().topLeftCorner<3, 3>() =
            Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitX()).toRotationMatrix();
    }
    return clip;
}

/// A chain of three bones with a material, a clip, and vertices of two bones.
inline Model paintedChain()
{
    Model model = chain("hips", 3, 0);
    model.surface.materials = {{.name = "paint"}};
    model.surface.vertices.resize(model.vertices.size());
    for (SkinWeights& skin : model.skin) {
        skin.bones[1] = (skin.bones[0] + 1) % 3;
        skin.weights = {0.75f, 0.25f};
    }
    model.clips = {clipOf(model, "nod", 0.5f)};
    return model;
}

}  // namespace knuckle
