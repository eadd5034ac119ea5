#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace knuckle {

/// The cell of a grid that a place is in.
inline Eigen::Vector3i cellOf(const Eigen::Vector3f& place, float side)
{
    return (place / side).array().floor().matrix().cast<int>();
}

/// A number for each cell, in the order z, y, x. Cells are within 2^20 of the middle.
inline int64_t cellKey(const Eigen::Vector3i& cell)
{
    const Eigen::Array<int64_t, 3, 1> at = cell.array().cast<int64_t>() + (1 << 20);
    return (at.z() << 42) | (at.y() << 21) | at.x();
}

inline Eigen::Vector3i cellOfKey(int64_t key)
{
    const auto part = [&](int shift) { return static_cast<int>((key >> shift & 0x1fffff) - (1 << 20)); };
    return {part(0), part(21), part(42)};
}

/// Calls back for each cell of a box, both ends included, x first.
template <typename Do>
void forEachCell(const Eigen::Vector3i& low, const Eigen::Vector3i& high, const Do& act)
{
    for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
            for (int x = low.x(); x <= high.x(); ++x) act(Eigen::Vector3i(x, y, z));
}

/// Places by their cells.
class CellOrder {
public:
    CellOrder(const std::vector<Eigen::Vector3f>& places, float side) : side_(side)
    {
        for (uint32_t i = 0; i < places.size(); ++i) order_.emplace_back(cellKey(cellOf(places[i], side)), i);
        std::ranges::sort(order_);
    }

    /// Calls back for each that is in the cell of a place or beside it.
    template <typename Do>
    void around(const Eigen::Vector3f& place, const Do& act) const
    {
        const Eigen::Vector3i middle = cellOf(place, side_);
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y) {
                // Three cells in a row have keys in a row.
                const Eigen::Vector3i first = middle + Eigen::Vector3i(-1, y, z);
                const int64_t key = cellKey(first);
                auto at = std::ranges::lower_bound(order_, std::pair<int64_t, uint32_t>(key, 0));
                for (; at != order_.end() && at->first <= key + 2; ++at) act(at->second);
            }
    }

private:
    float side_;
    std::vector<std::pair<int64_t, uint32_t>> order_;
};

}  // namespace knuckle
