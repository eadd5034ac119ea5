#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/world/matter/skin.h"

namespace knuckle {

/// A node of the skeleton. Parents come before their children.
struct Bone {
    std::string name;
    int32_t parent = -1;
    Eigen::Matrix4f restPose = Eigen::Matrix4f::Identity();  ///< Bone to model at rest, metres.
};

/// One vertex's skin: up to 8 bones, weights normalized to sum 1 (0 for unused slots).
struct SkinWeights {
    std::array<uint32_t, 8> bones{};
    std::array<float, 8> weights{};
};

/// Looks of a vertex of a model; as in SkinVertex.
struct SurfaceVertex {
    Eigen::Vector3f normal{0, 1, 0};
    Eigen::Vector2f uv{0, 0};
    Eigen::Vector3f color{1, 1, 1};
    uint32_t material = 0;  ///< Index into ModelSurface::materials.
};

/// Looks of a model: empty if not requested, or if its mesh was made up.
struct ModelSurface {
    std::vector<SurfaceVertex> vertices;  ///< Per vertex of the model.
    std::vector<SkinMaterial> materials;
    std::vector<TexturePicture> textures;
    std::vector<std::string> missing, notes;  ///< Parts that cannot be read; parts that were made smaller: a sentence
                                              ///< each.
};

/// A sampled clip: local poses per bone at keyTimes.
struct Clip {
    std::string name;
    double duration = 0.0;                            ///< [s]
    std::vector<double> keyTimes;                     ///< [s], ascending
    std::vector<std::vector<Eigen::Matrix4f>> poses;  ///< [key][bone], bone to model.
    std::vector<std::string> notes = {};              ///< Parts that are not played, one sentence each.
};

/// A clip of the file that cannot be played.
struct UnusableClip {
    std::string name;
    std::string why;  ///< "has keys that are not numbers"
};

/// Result of importModel() of import/import.h: triangles in metres, +Y up, in the rest pose, and the skeleton.
struct Model {
    std::string name;
    std::vector<Eigen::Vector3f> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<SkinWeights> skin;  ///< Empty, or one per vertex.
    ModelSurface surface;
    std::vector<Bone> bones;
    bool isSplit = false;  ///< Its bones are separate parts, each vertex belongs to one: they become bodies without
                           ///< joints.
    std::vector<Clip> clips;
    std::vector<UnusableClip> unusableClips;
    std::string poseFrom;            ///< Origin of the rest pose, such as "clip 'run' at 0.03 s"; empty: the file's
                                     ///< own.
    std::vector<std::string> notes;  ///< Repairs and assumptions of the import, one sentence each.
};

/// The place of a bone's head in a pose of it [m].
inline Eigen::Vector3f headIn(const Eigen::Matrix4f& pose)
{
    return pose.topRightCorner<3, 1>();
}
/// The same in the rest pose.
inline Eigen::Vector3f boneHead(const Model& model, uint32_t bone)
{
    return headIn(model.bones[bone].restPose);
}

}  // namespace knuckle
