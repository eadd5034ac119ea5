#include "sim/rig/import/assimp/clips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/rig/import/assimp/nodes/bones.h"
#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

using Eigen::Matrix4d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double SAMPLES_PER_SECOND = 60.0;
constexpr double DEFAULT_TICKS = 25.0;    // per second, if the file gives none
constexpr double LONGEST = 3600.0;        // [s]
constexpr unsigned MOST_KEYS = 500000;    // of one bone
constexpr size_t MATRIX_LIMIT = 1000000;  // bone poses of all clips together, 64 MB

Vector3d valueOf(const aiVectorKey& key)
{
    return {key.mValue.x, key.mValue.y, key.mValue.z};
}

Quaterniond valueOf(const aiQuatKey& key)
{
    return Quaterniond(key.mValue.w, key.mValue.x, key.mValue.y, key.mValue.z).normalized();
}

Vector3d between(const Vector3d& a, const Vector3d& b, double t)
{
    return a + t * (b - a);
}

Quaterniond between(const Quaterniond& a, const Quaterniond& b, double t)
{
    return a.slerp(t, b);
}

// The value at a time in ticks; constant before the first and after the last key.
template <typename Key>
auto sampleKeys(const Key* keys, unsigned count, double time)
{
    const Key* next = std::upper_bound(keys, keys + count, time, [](double t, const Key& k) { return t < k.mTime; });
    if (next == keys || next == keys + count) {
        return valueOf(next == keys ? keys[0] : keys[count - 1]);
    }
    const Key& before = next[-1];
    const double span = next->mTime - before.mTime;
    return between(valueOf(before), valueOf(*next), span > 0.0 ? (time - before.mTime) / span : 0.0);
}

Matrix4d sampleChannel(const aiNodeAnim& channel, const Eigen::Matrix3d& correction, const Matrix4d& rest, double time)
{
    Eigen::Affine3d restAffine(rest);
    Vector3d position = restAffine.translation();
    // Mirrors all axes, like assimp where it takes matrices apart.
    const double sign = rest.topLeftCorner<3, 3>().determinant() < 0.0 ? -1.0 : 1.0;
    const Vector3d restScale = rest.topLeftCorner<3, 3>().colwise().norm();
    Vector3d scale = sign * restScale;
    Eigen::Matrix3d rotation = sign * rest.topLeftCorner<3, 3>() *
                               restScale.cwiseMax(1e-12).cwiseInverse().asDiagonal();
    if (channel.mNumPositionKeys > 0) {
        position = sampleKeys(channel.mPositionKeys, channel.mNumPositionKeys, time);
    }
    if (channel.mNumRotationKeys > 0) {
        rotation = sampleKeys(channel.mRotationKeys, channel.mNumRotationKeys, time).toRotationMatrix() * correction;
    }
    if (channel.mNumScalingKeys > 0) {
        scale = sampleKeys(channel.mScalingKeys, channel.mNumScalingKeys, time);
    }
    Matrix4d m = Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = rotation * scale.asDiagonal();
    m.block<3, 1>(0, 3) = position;
    return m;
}

/// A clip's motion of a node.
struct NodeMotion {
    const aiNodeAnim* channel = nullptr;
    Eigen::Matrix3d correction = Eigen::Matrix3d::Identity();  ///< FbxChannel::correction.
    bool isContained = false;                                  ///< In the channel of a node below.
};

// Per node, its motion, if any. If a mesh and a bone have the same name, the channel is the bone's.
std::vector<NodeMotion> motionsByNode(const aiAnimation& animation, const NodeTable& table)
{
    std::map<std::string, uint32_t> nodeByName;
    for (uint32_t n = 0; n < table.nodes.size(); ++n) {
        const std::string name = table.nodes[n]->mName.C_Str();
        const auto found = nodeByName.find(name);
        if (found == nodeByName.end() || (table.boneOf[found->second] < 0 && table.boneOf[n] >= 0)) {
            nodeByName[name] = n;
        }
    }
    std::vector<NodeMotion> motions(table.nodes.size());
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
        const auto found = nodeByName.find(animation.mChannels[c]->mNodeName.C_Str());
        if (found == nodeByName.end()) continue;
        const FbxChannel channel = fbxChannel(*table.nodes[found->second]);
        motions[found->second].channel = animation.mChannels[c];
        motions[found->second].correction = channel.correction;
        for (const aiNode* contained : channel.contained) motions[table.indices.at(contained)].isContained = true;
    }
    return motions;
}

std::vector<Eigen::Matrix4f> poseAt(const std::vector<NodeMotion>& motions, const NodeTable& table, double ticks,
                                    size_t boneCount)
{
    std::vector<Matrix4d> locals = table.locals;
    for (size_t n = 0; n < locals.size(); ++n) {
        const NodeMotion& motion = motions[n];
        if (motion.isContained) locals[n].setIdentity();
        else if (motion.channel != nullptr)
            locals[n] = sampleChannel(*motion.channel, motion.correction, toEigen(table.nodes[n]->mTransformation),
                                      ticks);
        else continue;
        if (table.parents[n] < 0) locals[n] = table.upright * locals[n];
    }
    const std::vector<Matrix4d> globals = table.fbx.place(locals, table.parents);
    std::vector<Eigen::Matrix4f> poses(boneCount);
    for (size_t n = 0; n < globals.size(); ++n)
        if (table.boneOf[n] >= 0) poses[table.boneOf[n]] = bonePose(globals[n]);
    return poses;
}

// From the first key to the last, in ticks.
std::pair<double, double> spanOf(const aiAnimation& animation)
{
    double first = 1e300, last = -1e300;
    const auto include = [&](const auto* keys, unsigned count) {
        for (unsigned k = 0; k < count; ++k) {
            first = std::min(first, keys[k].mTime);
            last = std::max(last, keys[k].mTime);
        }
    };
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
        include(animation.mChannels[c]->mPositionKeys, animation.mChannels[c]->mNumPositionKeys);
        include(animation.mChannels[c]->mRotationKeys, animation.mChannels[c]->mNumRotationKeys);
        include(animation.mChannels[c]->mScalingKeys, animation.mChannels[c]->mNumScalingKeys);
    }
    return {first, last};
}

unsigned mostKeys(const aiAnimation& animation)
{
    unsigned most = 0;
    for (const aiNodeAnim* c : std::span(animation.mChannels, animation.mNumChannels))
        most = std::max({most, c->mNumPositionKeys, c->mNumRotationKeys, c->mNumScalingKeys});
    return most;
}

/// Whether any channel moves a bone.
bool movesBones(const std::vector<NodeMotion>& motions, const NodeTable& table)
{
    for (size_t n = 0; n < motions.size(); ++n)
        if (motions[n].channel && table.boneOf[n] >= 0) return true;
    return false;
}

/// The animation's name; later ones of the same name get a number, like skeletons.
std::string nameOf(const aiAnimation& animation, const Model& model)
{
    const std::string name = animation.mName.length > 0
                                 ? animation.mName.C_Str()
                                 : fmt::format("clip {}", model.clips.size() + model.unusableClips.size());
    const auto isTaken = [&](const std::string& wanted) {
        return std::ranges::find(model.clips, wanted, &Clip::name) != model.clips.end() ||
               std::ranges::find(model.unusableClips, wanted, &UnusableClip::name) != model.unusableClips.end();
    };
    std::string free = name;
    for (int times = 2; isTaken(free); ++times) free = fmt::format("{}#{}", name, times);
    return free;
}

/// Whether a channel changes the size of anything from that at rest.
bool scales(const aiNodeAnim& channel, const Matrix4d& rest)
{
    constexpr double SAME = 0.01;  // of a scale
    const Vector3d size = rest.topLeftCorner<3, 3>().colwise().norm();
    return std::any_of(channel.mScalingKeys, channel.mScalingKeys + channel.mNumScalingKeys,
                       [&](const aiVectorKey& key) {
                           return !((valueOf(key).cwiseAbs() - size).cwiseAbs().maxCoeff() <= SAME * size.maxCoeff());
                       });
}

void noteUnplayed(const aiAnimation& animation, const std::vector<NodeMotion>& motions, const NodeTable& table,
                  Clip& clip)
{
    if (animation.mNumMorphMeshChannels > 0)
        clip.notes.push_back(fmt::format("Clip '{}' changes shapes (morph weights): they stay as at rest.", clip.name));
    for (size_t n = 0; n < motions.size(); ++n) {
        if (motions[n].channel == nullptr || !scales(*motions[n].channel, toEigen(table.nodes[n]->mTransformation)))
            continue;
        clip.notes.push_back(fmt::format("Clip '{}' scales {}: bodies keep their size.", clip.name,
                                         table.nameOf(static_cast<uint32_t>(n))));
        break;
    }
    for (size_t n = 0; n < motions.size(); ++n) {
        const std::string axis = motions[n].channel == nullptr ? ""
                                                               : axisWithoutKeys(*table.nodes[n], *motions[n].channel);
        if (axis.empty()) continue;
        clip.notes.push_back(
            fmt::format("Clip '{}' has no keys for {}, or nothing but the default, which is played; the "
                        "node says otherwise. Bake all axes if that is not meant.",
                        clip.name, axis));
        return;
    }
}

void convertClip(const aiAnimation& animation, const NodeTable& table, size_t keyLimit, Model& model)
{
    const std::vector<NodeMotion> motions = motionsByNode(animation, table);
    if (table.isPicked && !movesBones(motions, table)) return;
    Clip clip;
    clip.name = nameOf(animation, model);
    noteUnplayed(animation, motions, table, clip);
    const auto refuse = [&](std::string why) { model.unusableClips.push_back({clip.name, std::move(why)}); };
    double ticksPerSecond = animation.mTicksPerSecond;
    if (!(ticksPerSecond > 0.0) || !std::isfinite(ticksPerSecond)) {
        ticksPerSecond = DEFAULT_TICKS;
        model.notes.push_back(fmt::format("Clip '{}' does not say how fast it runs: {} ticks a second assumed.",
                                          clip.name, DEFAULT_TICKS));
    }
    const auto [first, last] = spanOf(animation);
    clip.duration = (last - first) / ticksPerSecond;
    if (const unsigned keys = mostKeys(animation); keys > MOST_KEYS)
        return refuse(fmt::format("has {} keys of one bone, more than {}", keys, MOST_KEYS));
    if (!(clip.duration >= 0.0) || !std::isfinite(clip.duration))
        return refuse("has no keys, or none at sensible times");
    if (clip.duration > LONGEST) return refuse(fmt::format("lasts {:.0f} s, more than {:.0f}", clip.duration, LONGEST));
    // A little less, so that rounding does not add a sample, which would move all others off the file's keys.
    const size_t wanted = static_cast<size_t>(std::ceil(clip.duration * SAMPLES_PER_SECOND - 1e-3)) + 1;
    const size_t count = std::min(wanted, std::max<size_t>(keyLimit, 2));
    if (count < wanted) {
        model.notes.push_back(
            fmt::format("Clip '{}' was sampled {} times instead of {} to save memory.", clip.name, count, wanted));
    }
    for (size_t k = 0; k < count; ++k) {
        const double part = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0.0;
        clip.keyTimes.push_back(part * clip.duration);
        clip.poses.push_back(poseAt(motions, table, first + part * (last - first), model.bones.size()));
        if (!std::ranges::all_of(clip.poses.back(), [](const auto& pose) { return pose.allFinite(); }))
            return refuse("has keys that are not numbers");
    }
    model.clips.push_back(std::move(clip));
}

}  // namespace

void convertClips(const aiScene& scene, const NodeTable& table, Model& model)
{
    if (model.bones.empty() || scene.mNumAnimations == 0) {
        return;
    }
    const size_t keyLimit = MATRIX_LIMIT / (model.bones.size() * scene.mNumAnimations);
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
        convertClip(*scene.mAnimations[a], table, keyLimit, model);
    }
}

}  // namespace knuckle
