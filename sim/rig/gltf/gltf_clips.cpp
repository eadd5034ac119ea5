#include "sim/rig/gltf/gltf_clips.h"

#include <map>
#include <numeric>

#include "sim/rig/gltf/key_reduction.h"

namespace knuckle {

namespace {

constexpr float SAME_PLACE = 1e-5f;  // of a bone against its parent [m]
constexpr float UNSCALED = 1e-5f;    // deviation from the identity of a rotation times its transpose

/// Times of a clip's keys; tracks with the same keys share an accessor.
class KeyTimes {
public:
    explicit KeyTimes(const Clip& clip) : times_(clip.keyTimes.begin(), clip.keyTimes.end()) {}

    const std::vector<float>& all() const { return times_; }
    size_t accessorTo(GltfFile& file, const std::vector<size_t>& keys)
    {
        const auto [found, isNew] = accessors_.try_emplace(keys, 0);
        if (!isNew) return found->second;
        std::vector<float> chosen;
        for (const size_t k : keys) chosen.push_back(times_[k]);
        found->second = file.addAccessor(chosen, 1, GLTF_FLOAT, "SCALAR");
        file.setBounds(found->second, GltfJson::array({chosen.front()}), GltfJson::array({chosen.back()}));
        return found->second;
    }

private:
    std::vector<float> times_;
    std::map<std::vector<size_t>, size_t> accessors_;
};

/// Appends an accessor to the chosen keys' values.
template <typename Value>
GltfJson samplerOf(GltfFile& file, KeyTimes& times, const std::vector<Value>& values, const std::vector<size_t>& keys,
                   const char* type)
{
    std::vector<float> chosen;
    for (const size_t k : keys) {
        if constexpr (std::is_same_v<Value, Eigen::Quaternionf>) appendTo(chosen, values[k].coeffs());
        else appendTo(chosen, values[k]);
    }
    const size_t input = times.accessorTo(file, keys);
    return {{"input", input}, {"output", file.addAccessor(chosen, chosen.size() / keys.size(), GLTF_FLOAT, type)}};
}

void addChannel(GltfJson& animation, size_t node, const char* path, GltfJson sampler)
{
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back(std::move(sampler));
}

template <typename Value>
std::vector<size_t> chosenKeys(std::span<const float> times, const std::vector<Value>& values, float tolerance)
{
    if (tolerance > 0.0f) return keysOf(times, values, tolerance);
    std::vector<size_t> all(times.size());
    std::iota(all.begin(), all.end(), size_t{0});
    return all;
}

GltfJson& animationNamed(GltfFile& file, const std::string& name)
{
    for (size_t a = 0; a < file.count("animations"); ++a)
        if (file.root["animations"][a]["name"] == name) return file.root["animations"][a];
    const size_t added = file.append(
        "animations", {{"name", name}, {"channels", GltfJson::array()}, {"samplers", GltfJson::array()}});
    return file.root["animations"][added];
}

}  // namespace

Eigen::Matrix4f rigidPose(const Eigen::Matrix4f& pose)
{
    const Eigen::Matrix3f linear = pose.topLeftCorner<3, 3>();
    if ((linear.transpose() * linear).isIdentity(UNSCALED)) return pose;
    Eigen::Matrix3f rotation, scale;
    Eigen::Affine3f(pose).computeRotationScaling(&rotation, &scale);
    Eigen::Matrix4f rigid = pose;
    rigid.topLeftCorner<3, 3>() = rotation;
    return rigid;
}

LocalPose localPose(const Model& model, const std::vector<Eigen::Matrix4f>& pose, size_t bone)
{
    const int32_t parent = model.bones[bone].parent;
    Eigen::Matrix4f local = rigidPose(pose[bone]);
    if (parent >= 0) local = Eigen::Matrix4f(rigidPose(pose[static_cast<size_t>(parent)]).inverse() * local);
    return {local.block<3, 1>(0, 3), Eigen::Quaternionf(local.topLeftCorner<3, 3>()).normalized()};
}

void addClip(GltfFile& file, const Model& model, const Clip& clip, size_t firstBone, const GlbOptions& options)
{
    KeyTimes times(clip);
    std::vector<Eigen::Matrix4f> rest;
    for (const Bone& bone : model.bones) rest.push_back(bone.restPose);
    for (size_t b = 0; b < model.bones.size(); ++b) {
        std::vector<Eigen::Quaternionf> turns;
        std::vector<Eigen::Vector3f> places;
        const LocalPose atRest = localPose(model, rest, b);
        bool moves = model.bones[b].parent < 0;
        for (const std::vector<Eigen::Matrix4f>& key : clip.poses) {
            LocalPose pose = localPose(model, key, b);
            if (!turns.empty() && turns.back().dot(pose.rotation) < 0.0f) pose.rotation.coeffs() *= -1.0f;
            turns.push_back(pose.rotation);
            places.push_back(pose.translation);
            moves = moves || (pose.translation - atRest.translation).norm() > SAME_PLACE;
        }
        GltfJson turning = samplerOf(file, times, turns, chosenKeys(times.all(), turns, options.turnTolerance), "VEC4");
        GltfJson& animation = animationNamed(file, clip.name);
        addChannel(animation, firstBone + b, "rotation", std::move(turning));
        if (!moves) continue;
        GltfJson moving = samplerOf(file, times, places, chosenKeys(times.all(), places, options.shiftTolerance),
                                    "VEC3");
        addChannel(animationNamed(file, clip.name), firstBone + b, "translation", std::move(moving));
    }
}

}  // namespace knuckle
