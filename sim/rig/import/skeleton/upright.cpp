#include "sim/rig/import/skeleton/upright.h"

#include <fmt/format.h>

#include <span>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float ALONG = 0.8f;   // cosine between the direction from feet to head and the axis that a figure stands
                                // along
constexpr size_t SAMPLES = 64;  // of a clip

/// The direction from the feet to the head of a figure.
class Stature {
public:
    explicit Stature(std::span<const BoneAnatomy> anatomy)
    {
        for (size_t b = 0; b < anatomy.size(); ++b) {
            if (anatomy[b].part == BodyPart::Head) heads_.push_back(b);
            if (anatomy[b].part == BodyPart::Foot) feet_.push_back(b);
        }
    }
    bool isKnown() const { return !heads_.empty() && !feet_.empty(); }
    Vector3f in(std::span<const Eigen::Matrix4f> pose) const
    {
        return (middle(heads_, pose) - middle(feet_, pose)).normalized();
    }

private:
    static Vector3f middle(const std::vector<size_t>& bones, std::span<const Eigen::Matrix4f> pose)
    {
        Vector3f sum(0, 0, 0);
        for (const size_t b : bones) sum += headIn(pose[b]);
        return sum / static_cast<float>(bones.size());
    }

    std::vector<size_t> heads_, feet_;
};

/// The axis that a figure stands along, as a unit vector; 0 for none.
Vector3f axisAlong(const Vector3f& stature)
{
    Eigen::Index axis = 0;
    if (!stature.allFinite() || stature.cwiseAbs().maxCoeff(&axis) < ALONG) return Vector3f::Zero();
    return Vector3f::Unit(axis) * (stature[axis] > 0.0f ? 1.0f : -1.0f);
}

Vector3f meanStature(const Model& model, const Stature& stature)
{
    Vector3f sum(0, 0, 0);
    size_t count = 0;
    for (const Clip& clip : model.clips)
        for (size_t k = 0; k < clip.poses.size(); k += clip.poses.size() / SAMPLES + 1, ++count)
            sum += stature.in(clip.poses[k]);
    return count > 0 ? Vector3f(sum / static_cast<float>(count)) : sum;
}

std::string nameOf(const Vector3f& axis)
{
    Eigen::Index index = 0;
    axis.cwiseAbs().maxCoeff(&index);
    return fmt::format("{}{}", axis[index] < 0.0f ? "-" : "", "xyz"[index]);
}

}  // namespace

bool standUpright(Model& model, std::span<const BoneAnatomy> anatomy)
{
    const Stature stature(anatomy);
    if (!stature.isKnown()) return false;
    std::vector<Eigen::Matrix4f> pose;
    for (const Bone& bone : model.bones) pose.push_back(bone.restPose);
    const Vector3f atRest = axisAlong(stature.in(pose)), moving = axisAlong(meanStature(model, stature));
    const Vector3f up = moving.isZero() ? atRest : moving;
    const bool isToldTwice = atRest.isZero() || moving.isZero() || atRest == moving;
    if (up.isZero() || up == Vector3f::UnitY() || !isToldTwice) return false;
    Eigen::Matrix4f turn = Eigen::Matrix4f::Identity();
    turn.topLeftCorner<3, 3>() = Eigen::Quaternionf::FromTwoVectors(up, Vector3f::UnitY()).toRotationMatrix();
    for (Bone& bone : model.bones) bone.restPose = turn * bone.restPose;
    for (Clip& clip : model.clips)
        for (auto& poses : clip.poses)
            for (Eigen::Matrix4f& matrix : poses) matrix = turn * matrix;
    model.notes.push_back(fmt::format("The figure stands along {}: that was taken for up.", nameOf(up)));
    return true;
}

}  // namespace knuckle
