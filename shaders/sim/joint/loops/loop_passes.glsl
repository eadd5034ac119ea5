// Of a tree with many loops, joint_loop_factor goes through LOOPS_AT_ONCE in each of LOOP_PASSES passes, and
// joint_loop_solve goes on LOOP_SERIES times where LOOP_ROUNDS rounds do not do.
#ifdef LOOPS_AT_ONCE
BUFFER(uvec2, LoopPass, loopPass);   // per tree: passes so far; 1 if its loops hold
#else
#define LOOP_ROUNDS MOST_LOOP_ROUNDS
#endif

// What loops may be wrong by [rad and diameters].
#define LOOP_ERROR 2e-6

/// Loops first to end of a tree, that a pass factors.
uvec2 loopsOfPass(uint index, JointTree tree)
{
#ifdef LOOPS_AT_ONCE
    uint pass = loopPass[index].x, first = min(tree.firstLoop + LOOPS_AT_ONCE * pass, tree.loopEnd);
    loopPass[index].x = pass + 1u == LOOP_PASSES ? 0u : pass + 1u;
    return uvec2(first, min(first + LOOPS_AT_ONCE, tree.loopEnd));
#else
    return uvec2(tree.firstLoop, tree.loopEnd);
#endif
}

/// Whether a tree's loops hold already, and whether the pass is the last.
struct LoopSeries {
    bool hold, last;
};

LoopSeries beginSeries(uint index)
{
#ifdef LOOPS_AT_ONCE
    uvec2 now = loopPass[index];
    return LoopSeries(now.y != 0u, now.x + 1u == LOOP_SERIES);
#else
    return LoopSeries(false, true);
#endif
}

/// @param wrong by how much the tree's loops are wrong.
void endSeries(uint index, LoopSeries series, float wrong)
{
#ifdef LOOPS_AT_ONCE
    bool hold = series.hold || wrong <= LOOP_ERROR;
    loopPass[index] = series.last ? uvec2(0) : uvec2(loopPass[index].x + 1u, hold ? 1u : 0u);
#endif
}
