#include "render/compare/places.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "sim/base/disjoint_sets.h"

namespace knuckle {

namespace {

/// Changed pixels of a row that are joined, with how many there are.
struct Run {
    uint32_t y, first, last;
    uint64_t pixels;
};

std::vector<Run> findRuns(const std::vector<uint8_t>& marks, uint32_t width, uint32_t height, uint8_t least)
{
    std::vector<Run> runs;
    for (uint32_t y = 0; y < height; ++y) {
        const uint8_t* row = &marks[static_cast<size_t>(y) * width];
        for (uint32_t x = 0; x < width; ++x) {
            if (row[x] < least) continue;
            const bool joined = !runs.empty() && runs.back().y == y && x - runs.back().last <= PLACE_GAP + 1;
            if (!joined) runs.push_back({y, x, x, 0});
            runs.back().last = x;
            ++runs.back().pixels;
        }
    }
    return runs;
}

/// Unites each run with those near it in the rows above. Both lists go from left to right, so that one walk along them
/// meets all pairs.
void uniteRuns(const std::vector<Run>& runs, DisjointSets& sets)
{
    std::map<uint32_t, std::pair<size_t, size_t>> rows;  // The runs of each row, from the first to one past the last.
    for (size_t i = 0; i < runs.size(); ++i) {
        const auto row = rows.try_emplace(runs[i].y, i, i).first;
        row->second.second = i + 1;
    }
    for (auto row = rows.begin(); row != rows.end(); ++row) {
        for (auto above = row; above != rows.begin();) {
            --above;
            if (row->first - above->first > PLACE_GAP + 1) break;
            size_t upper = above->second.first;
            for (size_t lower = row->second.first; lower < row->second.second; ++lower) {
                const Run& run = runs[lower];
                while (upper < above->second.second && runs[upper].last + PLACE_GAP + 1 < run.first) ++upper;
                for (size_t k = upper; k < above->second.second && runs[k].first <= run.last + PLACE_GAP + 1; ++k)
                    sets.unite(static_cast<uint32_t>(lower), static_cast<uint32_t>(k));
            }
        }
    }
}

}  // namespace

std::vector<DifferencePlace> findPlaces(const std::vector<uint8_t>& marks, uint32_t width, uint32_t height,
                                        uint8_t least)
{
    const std::vector<Run> runs = findRuns(marks, width, height, least);
    DisjointSets sets(runs.size());
    uniteRuns(runs, sets);
    struct Bounds {
        uint32_t left, top, right, bottom;
        uint64_t pixels;
    };
    std::map<uint32_t, Bounds> found;
    for (size_t i = 0; i < runs.size(); ++i) {
        const Run& run = runs[i];
        Bounds& bounds =
            found.try_emplace(sets.find(static_cast<uint32_t>(i)), Bounds{run.first, run.y, run.last, run.y, 0})
                .first->second;
        bounds.left = std::min(bounds.left, run.first);
        bounds.right = std::max(bounds.right, run.last);
        bounds.bottom = std::max(bounds.bottom, run.y);
        bounds.pixels += run.pixels;
    }
    std::vector<DifferencePlace> places;
    for (const auto& [set, bounds] : found)
        places.push_back(
            {{bounds.left, bounds.top, bounds.right - bounds.left + 1, bounds.bottom - bounds.top + 1}, bounds.pixels});
    std::ranges::stable_sort(places, [](const DifferencePlace& p, const DifferencePlace& q) {
        return std::tuple(q.pixels, p.box.y, p.box.x) < std::tuple(p.pixels, q.box.y, q.box.x);
    });
    return places;
}

}  // namespace knuckle
