#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace knuckle {

/// Sets of the numbers 0, 1, 2 ... that are united pairwise; the least member of a set represents it, whatever the
/// order.
class DisjointSets {
public:
    /// @param count numbers, each in a set of its own.
    explicit DisjointSets(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }

    size_t size() const { return parents_.size(); }
    /// Adds a number, in a set of its own. @returns the number.
    uint32_t add()
    {
        parents_.push_back(static_cast<uint32_t>(parents_.size()));
        return parents_.back();
    }
    /// The least number in the set of i.
    uint32_t find(uint32_t i)
    {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void unite(uint32_t a, uint32_t b)
    {
        a = find(a);
        b = find(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<uint32_t> parents_;
};

}  // namespace knuckle
