#include "sim/rig/anatomy/clip_turns.h"

namespace knuckle {

namespace {

using Eigen::Matrix3f;
using Eigen::Matrix4f;

Matrix3f rotationOf(const Matrix4f& pose)
{
    return pose.topLeftCorner<3, 3>().colwise().normalized();
}

Matrix3f turnOf(const Model& model, const std::vector<Matrix4f>& poses, uint32_t bone)
{
    return rotationOf(poses[bone]) * rotationOf(model.bones[bone].restPose).transpose();
}

}  // namespace

std::vector<Turns> clipTurns(const Model& model, uint32_t bone, uint32_t parent)
{
    std::vector<Turns> clips;
    for (const Clip& clip : model.clips) {
        Turns turns;
        for (const std::vector<Matrix4f>& poses : clip.poses)
            turns.emplace_back(Matrix3f(turnOf(model, poses, parent).transpose() * turnOf(model, poses, bone)));
        clips.push_back(std::move(turns));
    }
    return clips;
}

Turns mirrored(Turns turns, const Eigen::Vector3f& across)
{
    // A turn's axis is not a direction: its image points the other way.
    for (Eigen::Quaternionf& turn : turns) turn.vec() = 2 * turn.vec().dot(across) * across - turn.vec();
    return turns;
}

}  // namespace knuckle
