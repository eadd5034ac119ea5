#include "tools/shapes/skeleton.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "tools/shapes/distance.h"

namespace knuckle {

using Eigen::Vector3d;

namespace {

constexpr double SKIN_FALLOFF = 6.0;  // weights fall with this power of the distance from the bone, in its radii
constexpr size_t BONES_PER_VERTEX = 4;

bool isLeft(const std::string& name)
{
    return name.ends_with(".L");
}

std::string otherSide(const std::string& name)
{
    return isLeft(name) ? name.substr(0, name.size() - 1) + "R" : name;
}

Vector3d otherSide(const Vector3d& point)
{
    return {-point.x(), point.y(), point.z()};
}

void add(Skeleton& skeleton, const BoneSpec& spec, bool mirror)
{
    const std::string parent = mirror ? otherSide(std::string(spec.parent)) : spec.parent;
    const int32_t above = parent.empty() ? -1 : static_cast<int32_t>(boneIndex(skeleton, parent));
    skeleton.push_back({mirror ? otherSide(std::string(spec.name)) : spec.name, above,
                        mirror ? otherSide(spec.head) : spec.head, mirror ? otherSide(spec.tail) : spec.tail,
                        spec.radius});
}

}  // namespace

Skeleton mirrored(std::span<const BoneSpec> specs)
{
    Skeleton skeleton;
    for (size_t first = 0; first < specs.size();) {
        add(skeleton, specs[first], false);
        size_t end = first + 1;
        if (isLeft(specs[first].name)) {
            for (; end < specs.size() && isLeft(specs[end].parent); ++end) add(skeleton, specs[end], false);
            for (const BoneSpec& spec : specs.subspan(first, end - first)) add(skeleton, spec, true);
        }
        first = end;
    }
    return skeleton;
}

uint32_t boneIndex(const Skeleton& skeleton, const std::string& name)
{
    const auto found = std::ranges::find(skeleton, name, &SkeletonBone::name);
    if (found == skeleton.end()) throw std::logic_error("no bone \"" + name + "\"");
    return static_cast<uint32_t>(found - skeleton.begin());
}

std::vector<Bone> bonesOf(const Skeleton& skeleton)
{
    std::vector<Bone> bones;
    for (const SkeletonBone& from : skeleton) {
        Bone bone;
        bone.name = from.name;
        bone.parent = from.parent;
        bone.restPose.block<3, 1>(0, 3) = from.head.cast<float>();
        bones.push_back(bone);
    }
    return bones;
}

SkinWeights weightsAt(const Skeleton& skeleton, const Vector3d& vertex)
{
    std::vector<double> weights;
    for (const SkeletonBone& bone : skeleton) {
        const double distance = std::max(segmentDistance(vertex, bone.head, bone.tail), 1e-3);
        weights.push_back(std::pow(distance / bone.radius, -SKIN_FALLOFF));
    }
    std::vector<uint32_t> order(skeleton.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](uint32_t a, uint32_t b) { return weights[a] > weights[b]; });
    double sum = 0.0;
    for (size_t i = 0; i < BONES_PER_VERTEX; ++i) sum += weights[order[i]];
    SkinWeights skin;
    for (size_t i = 0; i < BONES_PER_VERTEX; ++i) {
        skin.bones[i] = order[i];
        skin.weights[i] = static_cast<float>(std::round(weights[order[i]] / sum * 1e4) * 1e-4);
    }
    return skin;
}

}  // namespace knuckle
