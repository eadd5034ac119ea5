#include "sim/actor/anatomy/clip_hinges.h"

#include <algorithm>

namespace knuckle {

using Eigen::Matrix3f;
using Eigen::Matrix4f;
using Eigen::Vector3f;

namespace {

constexpr float MUCH = 0.35f;    // of a turn that shows an axis [rad]
constexpr float ASIDE = 0.035f;  // of a turn about other axes that is no turn [rad]

Matrix3f rotationOf(const Matrix4f& pose)
{
    return pose.topLeftCorner<3, 3>().colwise().normalized();
}

/// How a bone has turned since the rest pose, in the model's directions.
Matrix3f turnOf(const Model& model, const std::vector<Matrix4f>& poses, uint32_t bone)
{
    return rotationOf(poses[bone]) * rotationOf(model.bones[bone].restPose).transpose();
}

std::vector<Vector3f> turnsOf(const Model& model, uint32_t bone, uint32_t parent)
{
    std::vector<Vector3f> turns;
    for (const Clip& clip : model.clips)
        for (const std::vector<Matrix4f>& poses : clip.poses) {
            const Eigen::AngleAxisf turn(
                Matrix3f(turnOf(model, poses, parent).transpose() * turnOf(model, poses, bone)));
            turns.push_back(turn.angle() * turn.axis());
        }
    return turns;
}

}  // namespace

void readClipHinges(const Model& model, std::vector<BoneAnatomy>& anatomy)
{
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        BoneAnatomy& bone = anatomy[b];
        const bool unknown = bone.part == BodyPart::Other && bone.source == AnatomySource::None;
        if (!unknown || bone.role != BoneRole::Limb || bone.parent < 0) continue;
        const std::vector<Vector3f> turns = turnsOf(model, b, static_cast<uint32_t>(bone.parent));
        const auto most = std::ranges::max_element(turns, {}, [](const Vector3f& turn) { return turn.norm(); });
        if (most == turns.end() || most->norm() < MUCH) continue;
        const Vector3f axis = most->normalized();
        const auto isAside = [&](const Vector3f& turn) { return turn.cross(axis).norm() > ASIDE; };
        if (std::ranges::any_of(turns, isAside)) continue;
        bone.source = AnatomySource::Clip;
        bone.axis = axis;
    }
}

}  // namespace knuckle
