#include "tools/crate/crate.h"

#include <array>
#include <numbers>

#include "tools/shapes/figure.h"

namespace knuckle {

using Eigen::Matrix3f;
using Eigen::Vector3f;

namespace {

constexpr float HALF = 0.135f;   // of a side [m]
constexpr float BEAM = 0.028f;   // of the frame, square
constexpr float BRACE = 0.024f;  // wide
constexpr float CORE = 0.122f;   // from the middle to the surface that is visible between planks
constexpr float INNER = 0.115f;  // ... to where planks begin, within the core
constexpr float PLANKS = 0.127f;
constexpr float BRACES = 0.132f;
constexpr float GAP = 0.004f;  // between planks
constexpr int PLANK_COUNT = 4;

void addSide(Model& model, const std::array<Vector3f, 4>& corners, const Vector3f& color)
{
    const auto first = static_cast<uint32_t>(model.vertices.size());
    const Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalized();
    for (const Vector3f& corner : corners) {
        model.vertices.push_back(corner);
        model.surface.vertices.push_back({.normal = normal, .color = color});
        SkinWeights skin;
        skin.weights[0] = 1.0f;
        model.skin.push_back(skin);
    }
    model.triangles.push_back({first, first + 1, first + 2});
    model.triangles.push_back({first, first + 2, first + 3});
}

/// A box around a place, with its axes turned.
void addBox(Model& model, const Vector3f& middle, const Vector3f& half, const Matrix3f& turn, const Vector3f& color)
{
    std::array<Vector3f, 8> corners;
    for (size_t c = 0; c < corners.size(); ++c) {
        const Vector3f sign(c & 1 ? 1.0f : -1.0f, c & 2 ? 1.0f : -1.0f, c & 4 ? 1.0f : -1.0f);
        corners[c] = middle + turn * half.cwiseProduct(sign);
    }
    constexpr std::array<std::array<size_t, 4>, 6> SIDES{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& side : SIDES)
        addSide(model, {corners[side[0]], corners[side[1]], corners[side[2]], corners[side[3]]}, color);
}

/// Planks side by side within the frame, and a brace over those of an upright side.
void addPanel(Model& model, const Matrix3f& turn, bool braced)
{
    constexpr float width = 2 * (HALF - BEAM) / PLANK_COUNT;
    const std::array tints{screenColor(196, 150, 94), screenColor(182, 136, 82), screenColor(203, 158, 103),
                           screenColor(188, 143, 88)};
    const float depth = 0.5f * (PLANKS - INNER);
    for (int i = 0; i < PLANK_COUNT; ++i) {
        const Vector3f place((static_cast<float>(i) + 0.5f) * width - HALF + BEAM, 0, INNER + depth);
        addBox(model, turn * place, {0.5f * (width - GAP), HALF - BEAM, depth}, turn, tints[i]);
    }
    if (!braced) return;
    const float length = std::numbers::sqrt2_v<float> * (HALF - BEAM) - 0.5f * BRACE;
    const Matrix3f across = turn * Eigen::AngleAxisf(std::numbers::pi_v<float> / 4, Vector3f::UnitZ());
    addBox(model, turn * Vector3f(0, 0, 0.5f * (INNER + BRACES)), {0.5f * BRACE, length, 0.5f * (BRACES - INNER)},
           across, screenColor(160, 114, 66));
}

void addFrame(Model& model)
{
    const Vector3f color = screenColor(150, 105, 60);
    const float edge = HALF - 0.5f * BEAM;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float a : {-edge, edge}) {
            for (const float b : {-edge, edge}) {
                Vector3f middle = Vector3f::Zero(), half = Vector3f::Constant(0.5f * BEAM);
                middle[(axis + 1) % 3] = a;
                middle[(axis + 2) % 3] = b;
                half[axis] = axis == 1 ? HALF : HALF - BEAM;
                addBox(model, middle, half, Matrix3f::Identity(), color);
            }
        }
    }
}

}  // namespace

Model makeCrate()
{
    Model model;
    model.name = "crate";
    model.bones.push_back({"crate", -1});
    addBox(model, Vector3f::Zero(), Vector3f::Constant(CORE), Matrix3f::Identity(), screenColor(70, 48, 28));
    for (int side = 0; side < 4; ++side) {
        const float angle = 0.5f * std::numbers::pi_v<float> * static_cast<float>(side);
        addPanel(model, Eigen::AngleAxisf(angle, Vector3f::UnitY()).toRotationMatrix(), true);
    }
    for (const float way : {-0.5f, 0.5f})
        addPanel(model, Eigen::AngleAxisf(way * std::numbers::pi_v<float>, Vector3f::UnitX()).toRotationMatrix(),
                 false);
    addFrame(model);
    SkinMaterial material;
    material.name = model.name;
    material.color = {1, 1, 1};
    material.twoSided = false;
    model.surface.materials = {material};
    return model;
}

}  // namespace knuckle
