#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace knuckle::test {

/// A node of an FBX file. Angles in degrees. Members without a value are not written, so that readers use defaults.
struct FbxJoint {
    std::string name;
    int parent = -1;
    Eigen::Vector3d translation{0, 0, 0};
    std::optional<Eigen::Vector3d> rotation, scaling, preRotation, postRotation, rotationPivot, rotationOffset,
        scalingPivot, scalingOffset;
    std::optional<int> order;                        ///< 0 XYZ, 1 XZY, 2 YZX, 3 YXZ, 4 ZXY, 5 ZYX.
    std::optional<int> inherit;                      ///< "InheritType".
    std::vector<Eigen::Vector3d> turns, moves;       ///< Keys of Lcl Rotation and Lcl Translation, half a second apart.
    std::string turnAxes = "xyz", moveAxes = "xyz";  ///< Axes with curves.
};

/// An ASCII FBX 7.4 file of joints without a mesh, in metres, with one clip.
std::string fbxText(const std::vector<FbxJoint>& joints);

/// Nodes to the world at a key, after the FBX SDK's reference ("Computing transformation matrices"; ConvertToLocal of
/// its sample Transformations): T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1, and InheritType.
std::vector<Eigen::Matrix4d> fbxPose(const std::vector<FbxJoint>& joints, size_t key);

}  // namespace knuckle::test
