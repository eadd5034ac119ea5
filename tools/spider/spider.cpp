#include "tools/spider/spider.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tools/spider/spider_parts.h"

namespace knuckle {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Vector3d towards(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), 0, std::sin(angle)};
}

std::vector<BoneSpec> specs()
{
    std::vector<BoneSpec> all{
        {"body", "", {0, 0.320, -0.120}, {0, 0.320, 0.140}, 0.150},
        {"abdomen", "body", {0, 0.350, -0.220}, {0, 0.385, -0.420}, 0.130},
        {"head", "body", {0, 0.325, 0.215}, {0, 0.325, 0.320}, 0.090},
    };
    for (const SpiderLeg& leg : SPIDER_LEGS) {
        all.push_back({leg.bones[0], "body", leg.hip, inLeg(leg, FEMUR), 0.045});
        all.push_back({leg.bones[1], leg.bones[0], inLeg(leg, FEMUR), inLeg(leg, TIBIA), 0.040});
        all.push_back({leg.bones[2], leg.bones[1], inLeg(leg, TIBIA), inLeg(leg, FOOT), 0.032});
    }
    return all;
}

Model make()
{
    const std::vector<BoneSpec> all = specs();
    const Skeleton skeleton = mirrored(all);
    Model model = makeModel("spider", skeleton, spiderFigures(skeleton));
    model.clips = {spiderWalk(skeleton)};
    return model;
}

}  // namespace

const std::array<SpiderLeg, 3> SPIDER_LEGS{{
    {{"front_coxa.L", "front_femur.L", "front_tibia.L"}, {0.140, 0.320, 0.130}, towards(48), 0.0},
    {{"middle_coxa.L", "middle_femur.L", "middle_tibia.L"}, {0.175, 0.320, -0.005}, towards(2), 0.5},
    {{"rear_coxa.L", "rear_femur.L", "rear_tibia.L"}, {0.140, 0.320, -0.140}, towards(-46), 0.0},
}};

Vector3d inLeg(const SpiderLeg& leg, const Vector2d& place)
{
    return leg.hip + place.x() * leg.out + place.y() * Vector3d::UnitY();
}

Model makeSpider()
{
    static const Model model = make();
    return model;
}

Eigen::Vector3f spiderFoot(const std::string& tibia)
{
    for (const SkeletonBone& bone : mirrored(specs()))
        if (bone.name == tibia) return bone.tail.cast<float>();
    throw std::logic_error("no tibia \"" + tibia + "\"");
}

}  // namespace knuckle
