#include "tools/dog/dog.h"

#include <array>

#include "tools/dog/dog_parts.h"

namespace knuckle {

namespace {

const BoneSpec SPECS[] = {
    {"hips", "", {0, 0.530, -0.250}, {0, 0.535, -0.150}, 0.105},
    {"spine.001", "hips", {0, 0.535, -0.130}, {0, 0.525, 0.000}, 0.105},
    {"chest", "spine.001", {0, 0.525, 0.020}, {0, 0.520, 0.220}, 0.125},
    {"neck", "chest", {0, 0.575, 0.260}, {0, 0.690, 0.360}, 0.075},
    {"head", "neck", {0, 0.715, 0.375}, {0, 0.705, 0.520}, 0.075},
    {"ear.L", "head", {0.045, 0.785, 0.375}, {0.060, 0.850, 0.370}, 0.022},
    {"tail.001", "hips", {0, 0.565, -0.325}, {0, 0.595, -0.400}, 0.045},
    {"tail.002", "tail.001", {0, 0.605, -0.410}, {0, 0.655, -0.470}, 0.045},
    {"tail.003", "tail.002", {0, 0.665, -0.480}, {0, 0.735, -0.515}, 0.045},
    {"front_shoulder.L", "chest", {0.060, 0.560, 0.190}, {0.080, 0.455, 0.262}, 0.060},
    {"front_upper_leg.L", "front_shoulder.L", {0.082, 0.440, 0.265}, {0.085, 0.330, 0.192}, 0.050},
    {"front_lower_leg.L", "front_upper_leg.L", {0.085, 0.320, 0.185}, {0.085, 0.115, 0.199}, 0.038},
    {"front_foot.L", "front_lower_leg.L", {0.085, 0.100, 0.200}, {0.087, 0.025, 0.240}, 0.036},
    {"back_upper_leg.L", "hips", {0.075, 0.500, -0.250}, {0.090, 0.340, -0.189}, 0.075},
    {"back_lower_leg.L", "back_upper_leg.L", {0.090, 0.330, -0.185}, {0.088, 0.197, -0.300}, 0.045},
    {"back_foot.L", "back_lower_leg.L", {0.088, 0.185, -0.310}, {0.088, 0.050, -0.283}, 0.036},
    {"back_toe.L", "back_foot.L", {0.088, 0.038, -0.280}, {0.090, 0.025, -0.230}, 0.034},
};

Model make()
{
    const Skeleton skeleton = mirrored(SPECS);
    Model model = makeModel("dog", skeleton, std::array{dogFigure(skeleton)});
    model.clips = {dogWalk(skeleton), dogTrot(skeleton)};
    return model;
}

}  // namespace

Model makeDog()
{
    static const Model model = make();
    return model;
}

}  // namespace knuckle
