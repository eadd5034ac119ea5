#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// Points sorted by cubic cells, on the host.
class Cells {
public:
    using Cell = std::array<int, 3>;

    /// @param size of a cell [m], > 0.
    explicit Cells(float size) : inverseSize_(1.0f / size) {}
    void add(const Eigen::Vector3f& x, uint32_t index) { members_[cellOf(x)].push_back(index); }
    Cell cellOf(const Eigen::Vector3f& x) const
    {
        const Eigen::Vector3i c = (x * inverseSize_).array().floor().cast<int>();
        return {c.x(), c.y(), c.z()};
    }
    /// The members of each cell, in the order of the cells.
    const std::map<Cell, std::vector<uint32_t>>& members() const { return members_; }
    /// The members of the cell `k` of the 27 around a cell; null if there are none.
    const std::vector<uint32_t>* around(const Cell& cell, int k) const
    {
        const auto found = members_.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
        return found == members_.end() ? nullptr : &found->second;
    }
    /// Calls visit(index) for all members of the 27 cells around x.
    template <typename Visit>
    void forEachAround(const Eigen::Vector3f& x, Visit visit) const
    {
        for (int k = 0; k < 27; ++k) {
            const auto* members = around(cellOf(x), k);
            if (!members) continue;
            for (uint32_t i : *members) visit(i);
        }
    }
    /// The members whose particles are nearer to x than `distance`, which is at most a cell.
    std::vector<uint32_t> allNear(const std::vector<Particle>& particles, const Eigen::Vector3f& x,
                                  float distance) const
    {
        std::vector<uint32_t> all;
        forEachAround(x, [&](uint32_t i) {
            if ((particles[i].position - x).squaredNorm() < distance * distance) all.push_back(i);
        });
        return all;
    }
    /// One of them.
    std::optional<uint32_t> anyNear(const std::vector<Particle>& particles, const Eigen::Vector3f& x,
                                    float distance) const
    {
        const std::vector<uint32_t> all = allNear(particles, x, distance);
        return all.empty() ? std::nullopt : std::optional(all.front());
    }

private:
    float inverseSize_;
    std::map<Cell, std::vector<uint32_t>> members_;
};

}  // namespace knuckle
