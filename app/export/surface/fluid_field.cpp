#include "app/export/surface/fluid_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/export/surface/cell_order.h"

namespace knuckle {

namespace {

/// Reach of kernels in rest distances: smooth within a body of fluid, and narrow where a particle is by itself, which
/// would not come to a half anywhere.
constexpr float WIDE = 2.4f, NARROW = 1.4f;
/// Crowds, as shares of that within, between which they become wide.
constexpr float ALONE = 0.25f, TOGETHER = 0.5f;

/// The cubic spline of reach 1, times its volume (Monaghan 1992). @param square of the distance.
float spline(float square)
{
    if (square >= 1.0f) return 0.0f;
    constexpr auto WEIGHT = static_cast<float>(8.0 / std::numbers::pi);
    const float q = std::sqrt(square), rest = 1.0f - q;
    return WEIGHT * (q < 0.5f ? 1.0f - 6.0f * square * rest : 2.0f * rest * rest * rest);
}

/// The same sum as that of the field with round, wide kernels, at each particle.
std::vector<float> crowdsOf(const std::vector<FluidDrop>& drops, float spacing)
{
    const float reach = WIDE * spacing, scale = 1.0f / (reach * reach), weight = 1.0f / (WIDE * WIDE * WIDE);
    std::vector<Eigen::Vector3f> places;
    for (const FluidDrop& drop : drops) places.push_back(drop.place);
    const CellOrder cells(places, reach);
    std::vector<float> crowds;
    for (const Eigen::Vector3f& place : places) {
        float crowd = 0.0f;
        cells.around(place, [&](uint32_t other) { crowd += spline(scale * (places[other] - place).squaredNorm()); });
        crowds.push_back(weight * crowd);
    }
    return crowds;
}

}  // namespace

/// A particle's part.
struct FluidField::Kernel {
    Eigen::Vector3f place, axis;
    float across, along;  ///< Squares of distances across the axis, and what is added for those along it [1/m2].
    float weight, reach;  ///< [m]

    float at(const Eigen::Vector3f& point) const
    {
        const Eigen::Vector3f arm = point - place;
        const float part = axis.dot(arm);
        return weight * spline(across * arm.squaredNorm() + along * part * part);
    }
};

FluidField::Kernel FluidField::kernelOf(const FluidDrop& drop, float crowd, float spacing) const
{
    const float part = std::clamp((crowd - ALONE) / (TOGETHER - ALONE), 0.0f, 1.0f);
    const float reach = NARROW + (WIDE - NARROW) * part * part * (3.0f - 2.0f * part);
    // Of the same volume as a ball.
    const double size = std::cbrt(drop.form.along * drop.form.across * drop.form.across);
    const auto across = static_cast<float>(drop.form.across / size) * reach * spacing;
    const auto along = static_cast<float>(drop.form.along / size) * reach * spacing;
    return {.place = drop.place,
            .axis = drop.form.axis.cast<float>(),
            .across = 1.0f / (across * across),
            .along = 1.0f / (along * along) - 1.0f / (across * across),
            .weight = 1.0f / (reach * reach * reach),
            .reach = std::max(across, along)};
}

FluidField::FluidField(const std::vector<FluidDrop>& drops, float spacing) : step_(0.5f * spacing)
{
    const std::vector<float> crowds = crowdsOf(drops, spacing);
    std::vector<Kernel> kernels;
    for (size_t i = 0; i < drops.size(); ++i) kernels.push_back(kernelOf(drops[i], crowds[i], spacing));
    makeBlocks(kernels);
    for (const Kernel& kernel : kernels) add(kernel);
}

void FluidField::makeBlocks(const std::vector<Kernel>& kernels)
{
    const float side = step_ * BLOCK;
    for (const Kernel& kernel : kernels) {
        // A cell begins at its lowest corner.
        const Eigen::Vector3f reach = Eigen::Vector3f::Constant(kernel.reach + step_);
        forEachCell(cellOf(kernel.place - reach, side), cellOf(kernel.place + reach, side),
                    [&](const Node& cell) { keys_.push_back(cellKey(cell)); });
        if (keys_.size() < 4'000'000) continue;
        std::ranges::sort(keys_);
        keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    }
    std::ranges::sort(keys_);
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    blocks_.resize(keys_.size());
    for (size_t b = 0; b < blocks_.size(); ++b) blocks_[b].first = BLOCK * cellOfKey(keys_[b]);
}

int32_t FluidField::blockAt(const Node& node) const
{
    const auto down = [](int at) { return at >= 0 ? at / BLOCK : -((BLOCK - 1 - at) / BLOCK); };
    const int64_t key = cellKey({down(node.x()), down(node.y()), down(node.z())});
    const auto found = std::ranges::lower_bound(keys_, key);
    return found != keys_.end() && *found == key ? static_cast<int32_t>(found - keys_.begin()) : -1;
}

float FluidField::valueAt(const Node& node) const
{
    const int32_t block = blockAt(node);
    if (block < 0) return 0.0f;
    return blocks_[static_cast<size_t>(block)].values[placeIn(blocks_[static_cast<size_t>(block)], node)];
}

void FluidField::add(const Kernel& kernel)
{
    const Eigen::Vector3f reach = Eigen::Vector3f::Constant(kernel.reach);
    const Node low = cellOf(kernel.place - reach, step_), high = cellOf(kernel.place + reach, step_);
    forEachCell(cellOf(kernel.place - reach, step_ * BLOCK), cellOf(kernel.place + reach, step_ * BLOCK),
                [&](const Node& cell) {
                    Block& block = blocks_[static_cast<size_t>(blockAt(BLOCK * cell))];
                    const Node from = low.cwiseMax(block.first);
                    const Node to = high.cwiseMin(Node(block.first.array() + BLOCK - 1));
                    forEachCell(from, to, [&](const Node& node) {
                        block.values[placeIn(block, node)] += kernel.at(step_ * node.cast<float>());
                    });
                });
}

}  // namespace knuckle
