#pragma once

#include <algorithm>
#include <string>

#include "shared/constants.h"
#include "shared/joint_records.h"
#include "sim/gpu/program.h"
#include "sim/solver/layout/joint_trees.h"

namespace knuckle {

/// Loops of joints go through the whole tree of their bodies, one after another (joint_loop_factor) or all at once,
/// round by round (joint_loop_solve). A thread that does so for many would take longer than a driver lets it, so they
/// are split over passes.
struct LoopPasses {
    /// @param rounds of loops that a thread may run through (DeviceLimits::loopRounds).
    LoopPasses(const JointTrees& trees, uint32_t rounds)
    {
        // A group of threads goes through its trees together; the largest trees are the first.
        uint64_t bodies = 0, loops = 0;
        for (size_t t = 0; t < std::min<size_t>(trees.trees.size(), TREE_GROUP_SIZE); ++t)
            bodies += trees.trees[t].end - trees.trees[t].first;
        for (const JointTrees::Tree& tree : trees.trees)
            loops = std::max<uint64_t>(loops, tree.loopEnd - tree.firstLoop);
        if (loops == 0) return;
        // Six forces are tried for each, up the tree with its children and down again. What is left is for what passes
        // do besides.
        const uint64_t each = 6 * (4 * bodies + 4), round = 5 * bodies + 4 * loops + 8;
        const uint64_t besides = 14 * bodies + 8 * loops;
        const uint64_t all = std::max(std::min<uint64_t>(rounds, MOST_ROUNDS), besides) - besides;
        atOnce = static_cast<uint32_t>(std::clamp<uint64_t>(all / each, 1, loops));
        passes = static_cast<uint32_t>((loops + atOnce - 1) / atOnce);
        leastRounds = std::max(each, round) + besides;
        if (loops == 1) return;
        searchRounds = static_cast<uint32_t>(std::clamp<uint64_t>(all / round, 1, MOST_LOOP_ROUNDS));
        series = std::min((MOST_LOOP_ROUNDS + searchRounds - 1) / searchRounds, MOST_SERIES);
    }

    /// The variant of a kernel that goes through loops.
    Defines inPasses(Defines variant) const
    {
        if (passes == 1 && series == 1) return variant;
        const auto define = [&](const char* name, uint32_t value) {
            variant.push_back({name, std::to_string(value) + "u"});
        };
        define("LOOPS_AT_ONCE", atOnce);
        define("LOOP_PASSES", passes);
        define("LOOP_SERIES", series);
        define("LOOP_ROUNDS", searchRounds);
        return variant;
    }

    /// GPUs stop programs that run for seconds.
    static constexpr uint64_t MOST_ROUNDS = 1u << 20;
    static constexpr uint32_t MOST_SERIES = 8;

    uint32_t atOnce = 1;                       ///< Loops of a tree that a pass factors ...
    uint32_t passes = 1;                       ///< ... and how many passes that takes.
    uint32_t searchRounds = MOST_LOOP_ROUNDS;  ///< Rounds of a pass of joint_loop_solve ...
    uint32_t series = 1;                       ///< ... and how many of these there are.
    uint64_t leastRounds = 0;                  ///< Of a pass with one loop, or one round.
};

}  // namespace knuckle
