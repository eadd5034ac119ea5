#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/solver/measure/spheroid.h"

namespace knuckle {

/// A fluid particle, as a part of a smooth whole.
struct FluidDrop {
    Eigen::Vector3f place{0, 0, 0};  ///< [m]
    Spheroid form = {};
};

/// How much of a fluid is around each place, as a share of what is within it, at the nodes of a grid: the sum of smooth
/// kernels of its particles, stretched as these are, each of which holds the volume of one. At a flat surface it is
/// 0.5, whatever the kernel. Only the blocks of the grid that a particle reaches are there; elsewhere it is 0.
class FluidField {
public:
    static constexpr int BLOCK = 8;  ///< Nodes of a block along an axis.
    using Node = Eigen::Vector3i;    ///< Of the grid; its place is `step` times it.
    struct Block {
        Node first{0, 0, 0};
        std::array<float, BLOCK* BLOCK* BLOCK> values = {};  ///< x runs first.
    };

    /// @param spacing rest distance of the particles [m].
    FluidField(const std::vector<FluidDrop>& drops, float spacing);

    float step() const { return step_; }
    /// In the order of their corners: z, y, x. The one at which a cell with a value above 0 begins is always there.
    const std::vector<Block>& blocks() const { return blocks_; }
    /// The index of a node's block; -1: there is none.
    int32_t blockAt(const Node& node) const;
    float valueAt(const Node& node) const;
    static size_t placeIn(const Block& block, const Node& node)
    {
        const Node at = node - block.first;
        const int place = at.x() + BLOCK * (at.y() + BLOCK * at.z());
        return static_cast<size_t>(place);
    }

private:
    struct Kernel;
    Kernel kernelOf(const FluidDrop& drop, float crowd, float spacing) const;
    void makeBlocks(const std::vector<Kernel>& kernels);
    void add(const Kernel& kernel);

    float step_;
    std::vector<Block> blocks_;
    std::vector<int64_t> keys_;  ///< Of blocks, ascending.
};

}  // namespace knuckle
