#include "sim/rig/import/skeleton/rest_pose.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/shape/mirror_plane.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float FOLDED = 0.3f;       // second longest over longest side of the bounds
constexpr float UPRIGHT = 0.4f;      // height of the head over the feet, over the longest side
constexpr float LONG = 0.1f;         // the same for a figure that stands on its legs, however long it is
constexpr float HANGING = 0.8f;      // height of a hanging leg, over its length
constexpr float APART = 0.05f;       // distance of left from right, over the longest side
constexpr float SAME_PLACE = 1e-3f;  // of the size: a marker and its end
constexpr size_t FEWEST_MARKERS = 15;
constexpr double MARKER_PART = 0.8;  // of all bones, those that end on the same one

using BonePoses = std::vector<Eigen::Matrix4f>;

Eigen::AlignedBox3f boundsOf(const BonePoses& pose)
{
    Eigen::AlignedBox3f box;
    for (size_t b = 0; b < pose.size(); ++b) box.extend(headIn(pose[b]));
    return box;
}

/// The middle of some bones, and how many there are.
struct Middle {
    Vector3f sum{0, 0, 0};
    float count = 0.0f;

    void add(const Vector3f& place)
    {
        sum += place;
        count += 1.0f;
    }
    Vector3f mean() const { return sum / count; }
};

/// Whether most of a figure's legs hang down from their hips, as those of four-legged ones do at rest.
bool standsOnLegs(const Model& model, const BonePoses& pose, const std::vector<BoneAnatomy>& anatomy)
{
    int down = 0;
    for (uint32_t b = 0; b < pose.size(); ++b) {
        if (anatomy[b].part != BodyPart::Foot) continue;
        int32_t above = model.bones[b].parent;
        while (above >= 0 && anatomy[static_cast<size_t>(above)].part != BodyPart::Thigh)
            above = model.bones[static_cast<size_t>(above)].parent;
        if (above < 0) continue;
        const Vector3f leg = headIn(pose[static_cast<size_t>(above)]) - headIn(pose[b]);
        down += leg.y() > HANGING * leg.norm() ? 1 : -1;
    }
    return down > 0;
}

bool isPose(const Model& model, const BonePoses& pose, const std::vector<BoneAnatomy>& anatomy)
{
    Vector3f size = boundsOf(pose).sizes();
    const float longest = size.maxCoeff();
    Middle heads, feet, left, right;
    for (size_t b = 0; b < pose.size(); ++b) {
        const BodyPart part = anatomy[b].part;
        if (part == BodyPart::Head) heads.add(headIn(pose[b]));
        if (part == BodyPart::Foot || part == BodyPart::Shin) feet.add(headIn(pose[b]));
        if (anatomy[b].side > 0) left.add(headIn(pose[b]));
        if (anatomy[b].side < 0) right.add(headIn(pose[b]));
    }
    // A figure with more than two legs may hold its head anywhere.
    const bool hasMany = std::ranges::count(anatomy, BodyPart::Thigh, &BoneAnatomy::part) > 2;
    const bool isBody = !hasMany && heads.count > 0 && feet.count > 0 && left.count > 0 && right.count > 0;
    if (isBody) {
        const float height = heads.mean().y() - feet.mean().y();
        const bool stands = height > LONG * longest && standsOnLegs(model, pose, anatomy);
        return (height > UPRIGHT * longest || stands) && (left.mean() - right.mean()).norm() > APART * longest;
    }
    std::sort(size.data(), size.data() + 3);
    return size[1] > FOLDED * size[2];
}

/// Refuses points that all hang on the same one.
void refuseMarkers(const Model& model)
{
    const BoneTree tree(model);
    const float size = sizeOf(tree);
    const auto isPoint = [&](uint32_t bone) {
        return std::ranges::all_of(tree.children[bone], [&](uint32_t end) {
            return tree.children[end].empty() && (tree.heads[end] - tree.heads[bone]).norm() < SAME_PLACE * size;
        });
    };
    // End sites of files are bones of their own.
    const auto joints = std::ranges::count_if(tree.children, [](const auto& children) { return !children.empty(); });
    for (uint32_t b = 0; b < tree.size(); ++b) {
        const auto ends = static_cast<size_t>(std::ranges::count_if(tree.children[b], isPoint));
        if (ends >= FEWEST_MARKERS && static_cast<double>(ends) >= MARKER_PART * static_cast<double>(joints))
            throw InputError(
                fmt::format("it holds {} points that all hang on '{}': a cloud of markers, not a skeleton; "
                            "give the skeleton that was made from it",
                            ends, model.bones[b].name));
    }
}

}  // namespace

bool chooseRestPose(Model& model, const std::vector<BoneAnatomy>& anatomy)
{
    refuseMarkers(model);
    BonePoses rest;
    for (const Bone& bone : model.bones) rest.push_back(bone.restPose);
    if (model.clips.empty() || isPose(model, rest, anatomy)) return false;
    const Clip& first = model.clips.front();
    const Clip* clip = &first;
    const BonePoses* chosen = &first.poses.front();
    for (const Clip& other : model.clips) {
        const auto pose = std::ranges::find_if(other.poses,
                                               [&](const BonePoses& p) { return isPose(model, p, anatomy); });
        if (pose == other.poses.end()) continue;
        clip = &other;
        chosen = &*pose;
        break;
    }
    const double time = clip->keyTimes[static_cast<size_t>(chosen - clip->poses.data())];
    const Eigen::AlignedBox3f box = boundsOf(*chosen);
    const Vector3f origin(box.center().x(), box.min().y(), box.center().z());
    for (size_t b = 0; b < model.bones.size(); ++b) {
        model.bones[b].restPose = (*chosen)[b];
        model.bones[b].restPose.block<3, 1>(0, 3) -= origin;
    }
    model.poseFrom = fmt::format("clip '{}' at {:.2f} s", clip->name, time);
    model.notes.push_back(
        fmt::format("The skeleton's rest pose is none that a body has: that of {} was taken, moved to "
                    "the origin.",
                    model.poseFrom));
    return true;
}

}  // namespace knuckle
