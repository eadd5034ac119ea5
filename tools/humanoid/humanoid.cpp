#include "tools/humanoid/humanoid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/humanoid/humanoid_look.h"

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double FINEST_CELL = 0.0014;  // of the mesh, at the eyes [m]
constexpr double HAND_BLEND = 0.02;     // width over which hands blend into arms [m]

// Proportions of an adult of 1.75 m: 7.5 heads, hips at 53 % of the height.
const BoneSpec SPECS[] = {
    {"hips", "", {0, 0.95, -0.005}, {0, 1.04, -0.01}, 0.135},
    {"spine", "hips", {0, 1.05, -0.01}, {0, 1.18, -0.01}, 0.135},
    {"chest", "spine", {0, 1.19, -0.01}, {0, 1.41, -0.01}, 0.15},
    {"neck", "chest", {0, 1.46, -0.012}, {0, 1.53, 0.0}, 0.075},
    {"head", "neck", {0, 1.545, 0.005}, {0, 1.70, 0.015}, 0.09},
    {"clavicle.L", "chest", {0.045, 1.41, -0.01}, {0.15, 1.415, -0.01}, 0.065},
    {"upper_arm.L", "clavicle.L", {0.185, 1.405, -0.01}, {0.355, 1.205, -0.012}, 0.05},
    {"forearm.L", "upper_arm.L", {0.365, 1.195, -0.012}, {0.52, 1.015, 0.012}, 0.042},
    {"hand.L", "forearm.L", {0.528, 1.005, 0.014}, {0.625, 0.885, 0.035}, 0.04},
    {"thigh.L", "hips", {0.098, 0.91, 0.0}, {0.118, 0.52, 0.008}, 0.08},
    {"shin.L", "thigh.L", {0.119, 0.495, 0.008}, {0.132, 0.11, -0.022}, 0.055},
    {"foot.L", "shin.L", {0.133, 0.085, -0.024}, {0.155, 0.03, 0.13}, 0.05},
};

double distanceAt(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    const double body = melt(bodyDistance(left), handDistance(left), HAND_BLEND);
    return std::max(headDistance(p, body), -p.y());  // flat soles on the ground
}

double cellAt(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    const double feature = featureDistance(left);
    if (feature < 0.0) return FINEST_CELL;
    if (feature < 0.005) return 2.0 * FINEST_CELL;
    const bool face = left.y() > 1.59 && left.y() < 1.68 && left.x() < 0.052 && p.z() > 0.075;
    const bool fingers = left.x() > 0.595 && left.y() < 0.93;
    if (face || fingers) return 4.0 * FINEST_CELL;
    const bool hand = left.x() > 0.5, head = left.y() > 1.47, shoe = left.y() < 0.1 && left.y() > 0.011;
    return hand || head || shoe || hemDistance(left) < 0.0095 ? 8.0 * FINEST_CELL : 16.0 * FINEST_CELL;
}

Vector3f colorOf(Region region)
{
    switch (region) {
        case LIPS: return screenColor(196, 112, 100);
        case MOUTH: return screenColor(92, 40, 38);
        case EYE_WHITE: return screenColor(240, 237, 230);
        case IRIS: return screenColor(70, 116, 116);
        case PUPIL: return screenColor(14, 12, 14);
        case LASHES: return screenColor(38, 24, 20);
        case BROW: return screenColor(66, 40, 28);
        case HAIR: return screenColor(70, 42, 28);
        case SHIRT: return screenColor(236, 228, 212);
        case SLEEVE: return screenColor(32, 104, 112);
        case BELT: return screenColor(96, 58, 36);
        case BUCKLE: return screenColor(214, 174, 100);
        case TROUSERS: return screenColor(48, 60, 92);
        case CUFF: return screenColor(112, 130, 164);
        case SOCK: return screenColor(236, 234, 230);
        case SHOE: return screenColor(206, 74, 50);
        case LACE:
        case SOLE: return screenColor(244, 241, 234);
        default: return screenColor(226, 172, 138);
    }
}

// A little red in cheeks, nose and ears.
Vector3f colorAt(Region region, const Vector3d& p)
{
    Vector3f color = colorOf(region);
    if (region != BODY_SKIN || p.y() < 1.5) return color;
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    const double near = std::min((left - Vector3d(0.046, 1.608, 0.083)).norm() / 0.024,
                                 (left - Vector3d(0, 1.607, 0.122)).norm() / 0.016);
    const float blush = static_cast<float>(0.30 * std::exp(-near * near));
    return color + blush * (screenColor(216, 120, 104) - color);
}

}  // namespace

Figure humanoidFigure(const Skeleton& skeleton)
{
    Figure figure;
    figure.distance = distanceAt;
    figure.grid = {{0, 640 * FINEST_CELL, 0}, FINEST_CELL, 11, cellAt};  // y = 0 between cells
    figure.regionAt = [](const Vector3d& p) -> Region {
        const Vector3d left(std::abs(p.x()), p.y(), p.z());
        return p.y() > 1.52 ? headRegionAt(p) : clothesAt(left);
    };
    figure.colorAt = colorAt;
    figure.weightsAt = [skeleton](Region, const Vector3d& p) { return weightsAt(skeleton, p); };
    return figure;
}

namespace {

Model make()
{
    const Skeleton skeleton = mirrored(SPECS);
    Model model = makeModel("humanoid", skeleton, std::array{humanoidFigure(skeleton)});
    model.clips.push_back(humanoidDance(model.bones));
    model.clips.push_back(humanoidWalk(model.bones));
    return model;
}

}  // namespace

Model makeHumanoid()
{
    static const Model model = make();
    return model;
}

}  // namespace knuckle
