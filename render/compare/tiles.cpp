#include "render/compare/tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/compare/neighbours.h"
#include "render/compare/parallel.h"

namespace knuckle {

namespace {

/// Side of the cells that tiles consist of: half of the smallest tile.
constexpr uint32_t CELL = 4;
constexpr std::array<uint32_t, 4> TILE_SIZES{8, 16, 32, 64};
/// From this size on, the mean of the signed difference counts. Below it, a few pixels of an edge make one.
constexpr uint32_t SHIFT_SIZE = 32;
constexpr double ROUNDING = 2.0, ROUNDING_SHIFT = 1.0;
/// So that a single pixel of HDR light does not count for a whole tile.
constexpr double MOST = 255.0;

/// Sums over a cell: of what is not explained, and of b - a by channel.
struct CellSums {
    double unexplained = 0.0;
    std::array<double, 4> shift = {};

    CellSums& add(const CellSums& other, double sign)
    {
        unexplained += sign * other.unexplained;
        for (size_t c = 0; c < 4; ++c) shift[c] += sign * other.shift[c];
        return *this;
    }
};

void addPixel(const Picture& a, const Picture& b, uint32_t x, uint32_t y, CellSums& sums)
{
    const size_t at = (static_cast<size_t>(y) * a.width + x) * 4;
    double unexplained = 0.0, alpha = 0.0;
    for (size_t c = 0; c < 4; ++c) {
        const double shift = std::clamp(inSteps(b.rgba[at + c]) - inSteps(a.rgba[at + c]), -MOST, MOST);
        sums.shift[c] += shift;
        if (std::fabs(shift) <= ROUNDING) continue;
        const double outside = std::max(outsideNeighbours(a, b, x, y, c), outsideNeighbours(b, a, x, y, c));
        const double beyond = std::min(MOST, std::max(0.0, outside - ROUNDING));
        if (c < 3) unexplained += beyond / 3.0;
        else alpha = beyond;
    }
    sums.unexplained += std::max(unexplained, alpha);
}

/// Sums over all cells above and to the left of a corner: those of a tile are four of them.
struct CellTable {
    uint32_t columns, rows;
    std::vector<CellSums> sums;  ///< (columns + 1) * (rows + 1)

    CellSums over(uint32_t left, uint32_t top, uint32_t right, uint32_t bottom) const
    {
        const auto at = [this](uint32_t x, uint32_t y) { return sums[static_cast<size_t>(y) * (columns + 1) + x]; };
        return at(right, bottom).add(at(left, bottom), -1).add(at(right, top), -1).add(at(left, top), 1);
    }
};

CellTable makeTable(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks, unsigned threads)
{
    CellTable table{(a.width + CELL - 1) / CELL, (a.height + CELL - 1) / CELL, {}};
    const size_t stride = table.columns + 1;
    table.sums.resize(stride * (table.rows + 1));
    forEachParallel(table.rows, threads, [&](size_t row) {
        const auto top = static_cast<uint32_t>(row) * CELL;
        for (uint32_t y = top; y < std::min(top + CELL, a.height); ++y)
            for (uint32_t x = 0; x < a.width; ++x)
                if (marks[static_cast<size_t>(y) * a.width + x] != 0)
                    addPixel(a, b, x, y, table.sums[(row + 1) * stride + x / CELL + 1]);
    });
    for (size_t row = 1; row <= table.rows; ++row)
        for (size_t column = 1; column <= table.columns; ++column) {
            CellSums& sum = table.sums[row * stride + column];
            sum.add(table.sums[row * stride + column - 1], 1).add(table.sums[(row - 1) * stride + column], 1);
            sum.add(table.sums[(row - 1) * stride + column - 1], -1);
        }
    return table;
}

double scoreOf(const CellSums& sums, double pixels, uint32_t size)
{
    double mean = sums.unexplained / pixels;
    if (size >= SHIFT_SIZE)
        for (const double shift : sums.shift) mean = std::max(mean, std::fabs(shift) / pixels - ROUNDING_SHIFT);
    // Sums that have been subtracted from each other are zero only nearly.
    return mean < 1e-9 ? 0.0 : mean * std::sqrt(size / 8.0);
}

}  // namespace

TileDifference findWorstTile(const Picture& a, const Picture& b, const std::vector<uint8_t>& marks, unsigned threads)
{
    const CellTable table = makeTable(a, b, marks, threads);
    TileDifference worst;
    for (const uint32_t size : TILE_SIZES) {
        const uint32_t cells = size / CELL, step = cells / 2;
        for (uint32_t top = 0; top == 0 || top + step < table.rows; top += step)
            for (uint32_t left = 0; left == 0 || left + step < table.columns; left += step) {
                const uint32_t right = std::min(left + cells, table.columns);
                const uint32_t bottom = std::min(top + cells, table.rows);
                PixelBox box{left * CELL, top * CELL, 0, 0};
                box.width = std::min(right * CELL, a.width) - box.x;
                box.height = std::min(bottom * CELL, a.height) - box.y;
                const double score = scoreOf(table.over(left, top, right, bottom),
                                             static_cast<double>(box.width) * box.height, size);
                if (score > worst.score * (1.0 + 1e-9)) worst = {score, box};
            }
    }
    return worst;
}

}  // namespace knuckle
