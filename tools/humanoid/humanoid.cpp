#include "tools/humanoid/humanoid.h"

#include <algorithm>
#include <cmath>

#include "tools/shapes/distance.h"
#include "tools/shapes/skeleton.h"
#include "tools/shapes/surface_nets.h"

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double MESH_STEP = 0.021;              // [m]
constexpr double HALF_WIDTH = 35.5 * MESH_STEP;  // of the meshed box: the grid mirrors like the body does
constexpr double BLEND = 0.035;                  // width over which limbs melt into each other [m]

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

// The left half of the body and what lies on the middle; the distance mirrors x.
const Limb LIMBS[] = {
    {{0, 0.95, -0.005}, {0.065, 0.95, -0.005}, 0.100, 0.092},       // pelvis
    {{0.062, 0.915, -0.045}, {0.075, 0.90, -0.045}, 0.075, 0.072},  // seat
    {{0, 1.08, 0.0}, {0.045, 1.08, 0.0}, 0.092, 0.080},             // waist
    {{0.03, 0.98, -0.005}, {0.045, 1.30, -0.005}, 0.090, 0.094},    // trunk
    {{0, 1.27, -0.005}, {0.072, 1.29, -0.005}, 0.105, 0.095},       // ribs
    {{0.06, 1.335, 0.02}, {0.085, 1.33, 0.015}, 0.066, 0.062},      // breast
    {{0, 1.40, -0.015}, {0.15, 1.405, -0.012}, 0.062, 0.052},       // shoulders
    {{0.175, 1.40, -0.01}, {0.19, 1.385, -0.01}, 0.060, 0.058},     // deltoid
    {{0, 1.43, -0.015}, {0, 1.55, 0.0}, 0.060, 0.052},              // neck
    {{0, 1.585, 0.025}, {0, 1.565, 0.055}, 0.062, 0.038},           // jaw
    {{0, 1.60, 0.09}, {0, 1.625, 0.10}, 0.018, 0.012},              // nose
    {{0.195, 1.39, -0.01}, {0.365, 1.195, -0.012}, 0.055, 0.042},
    {{0.365, 1.195, -0.012}, {0.43, 1.12, -0.002}, 0.043, 0.043},
    {{0.43, 1.12, -0.002}, {0.528, 1.005, 0.014}, 0.043, 0.029},
    {{0.535, 0.995, 0.016}, {0.58, 0.94, 0.028}, 0.030, 0.033},  // palm, widened across below
    {{0.562, 0.95, 0.045}, {0.575, 0.935, 0.0}, 0.026, 0.026},
    {{0.58, 0.94, 0.04}, {0.63, 0.87, 0.042}, 0.024, 0.016},  // fingers
    {{0.585, 0.935, 0.012}, {0.625, 0.875, 0.018}, 0.024, 0.016},
    {{0.54, 0.975, 0.04}, {0.575, 0.93, 0.085}, 0.020, 0.014},    // thumb
    {{0.095, 0.90, 0.0}, {0.119, 0.50, 0.01}, 0.086, 0.056},      // thigh
    {{0.119, 0.50, 0.012}, {0.124, 0.36, -0.012}, 0.055, 0.057},  // calf
    {{0.124, 0.36, -0.012}, {0.133, 0.085, -0.025}, 0.056, 0.038},
    {{0.133, 0.04, -0.055}, {0.135, 0.05, 0.0}, 0.040, 0.044},  // heel
    {{0.135, 0.05, 0.0}, {0.158, 0.022, 0.135}, 0.046, 0.030},  // foot
};

constexpr double HEAD_TOP = 1.75;
const Vector3d HEAD_RADII{0.080, 0.115, 0.098};
const Vector3d HEAD_CENTRE{0, HEAD_TOP - 0.115, 0.012};

double bodyDistance(const Vector3d& point)
{
    const Vector3d p(std::abs(point.x()), point.y(), point.z());
    double distance = ellipsoidDistance(p, HEAD_CENTRE, HEAD_RADII);
    for (const Limb& limb : LIMBS) {
        distance = melt(distance, limbDistance(p, limb), BLEND);
    }
    return std::max(distance, -p.y());  // flat soles on the ground
}

}  // namespace

Model makeHumanoid()
{
    const Skeleton skeleton = mirrored(SPECS);
    Model model;
    model.name = "humanoid";
    model.bones = bonesOf(skeleton);
    TriangleMesh mesh = surfaceNets(bodyDistance, {-HALF_WIDTH, -0.05, -0.2}, {HALF_WIDTH, 1.81, 0.26}, MESH_STEP);
    model.vertices = std::move(mesh.vertices);
    model.triangles = std::move(mesh.triangles);
    for (const Vector3f& vertex : model.vertices) {
        model.skin.push_back(weightsAt(skeleton, vertex.cast<double>()));
    }
    model.clips.push_back(humanoidDance(model.bones));
    model.clips.push_back(humanoidWalk(model.bones));
    return model;
}

}  // namespace knuckle
