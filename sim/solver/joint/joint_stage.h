#pragma once

#include "sim/solver/joint/loop_passes.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Joints: particles that bodies share (paper, section 4), as trees of bodies that are solved at once.
///
///     World::joints --> JointTrees --> jointTrees[tree]    joints from .. to, loops from .. to
///                                      jointInfo[joint]    body, parent, rows, children; loops stand behind all others
///                                      jointFreedoms, jointPlaces, jointLimits, jointStrengths [joint]
///
/// Records, in texels of 16 bytes (shaders/shared/joint_records.h), and how kernels pass them on in a substep, for a
/// tree of a root and two bodies:
///
///     joint_factor, from the leaves up:             joint_solve, up:            and down:
///
///       root    <- bodyLoads (4)                      root    <- bodyLoads        root    -> its motion, by
///         |        rootFactors (6) ->                 |                           |        rootFactors
///         |  ^ jointInertias (6): inertia that            |  ^ passed force           |  v motion of the parent
///         |    the parent sees                          |    (jointSweeps, 9)       |
///       body    <- bodyLoads                          body    <- bodyLoads,       body    -> its motion, by
///         |        jointFactors (11) ->                 |        joint's error      |        jointFactors; to rows,
///         |  ^ jointInertias                              |  ^ passed force           |  v     the force that holds
///       body    <- bodyLoads                          body                        body
///
/// Where all trees are short, and nothing limits, drives or closes loops, what they pass on stays in registers
/// (SHORT_TREES, shaders/sim/joint/short_tree.glsl), without jointInertias and jointSweeps.
///
/// A joint that closes a loop is a force between two bodies of the tree: joint_loop_factor finds how far a unit of it
/// moves them apart (loopFactors, 10), joint_loop_solve corrects the rest of its error. Limits (jointLimitStates, 4)
/// are springs that only push, in the same blocks. joint_factor runs again when other limits hold than before, or
/// bodies have turned (treeTurns). If something needs to know how bodies answer to forces with all that hangs on them,
/// joint_factor stores bodyResponses (9). joint_tear compares jointLoads (2) with the joints' strengths.
class JointStage : public Stage {
public:
    explicit JointStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;
    /// Reserves a row for each body of a joint that can move.
    static void reserveRows(RowPlan& rows, const World& world, const Layout& layout);

    /// Factors how the bodies of each tree answer to each other; once in a substep.
    void factor(Recorder& recorder) const;
    /// The same for trees whose bodies have turned too far since, or whose limits have changed; in each iteration.
    /// @param last whether it is the last of several iterations, in which no rigid limit lets go.
    void factorAgain(Recorder& recorder, bool last) const;
    /// Moves bodies by the impulses on them and to where their joints hold. @param first in the substep.
    void solve(Recorder& recorder, bool first = false) const;
    /// Tears joints that bore too much; at the end of a substep.
    void tear(Recorder& recorder) const;
    /// Per particle of a world, whether a joint that shared it is torn; empty if none can tear. Stalls until the GPU is
    /// done.
    std::vector<bool> tornParticles(const World& world) const;
    /// Puts shared particles at the mean of where their bodies have them, at the end of a step.
    void placeParticles(Recorder& recorder) const;

    Buffer<uint32_t> sharedParticles;  ///< The particles of two or more bodies.
    // Of the trees (layout/joint_trees.h).
    Buffer<gpu::uvec4> jointTrees;        ///< First joint, end; first loop, end.
    Buffer<gpu::Joint> jointInfo;         ///< Per joint, those that close loops last.
    Buffer<uint32_t> jointFreedoms;       ///< Per joint: JOINT_*; of a torn one JOINT_NONE.
    Buffer<gpu::vec4> jointPlaces;        ///< Per joint: arms in the two bodies [m], axes in the two.
    Buffer<gpu::vec4> jointFactors;       ///< Per joint of a tree: its body with all that hangs on it.
    Buffer<gpu::vec4> rootFactors;        ///< Per joint of a tree: how its body answers if nothing holds it.
    Buffer<float> treeTurns;              ///< Per tree: the largest turn of a body in the last solve [rad], squared.
    Buffer<gpu::vec4> jointInertias;      ///< Per joint of a tree: the inertia of its body that its parent sees.
    Buffer<gpu::vec4> jointSweeps;        ///< Per joint of a tree: values that the sweeps pass to each other.
    Buffer<gpu::vec4> loopFactors;        ///< Per joint that closes a loop: how its ends move apart.
    Buffer<gpu::uvec2> loopPass;          ///< Per tree with many loops: passes so far; 1 if they hold.
    Buffer<gpu::vec4> loopSearches;       ///< Per joint that closes a loop: where the search for its force is.
    Buffer<gpu::vec4> loopPulls;          ///< Per joint of a tree, two: what its loops pull its body by.
    Buffer<gpu::JointRange> jointLimits;  ///< Per joint, if any has limits.
    Buffer<gpu::vec4> jointLimitStates;   ///< Per joint: where its limits stop it, and how hard.
    Buffer<gpu::uvec4> jointStrengths;    ///< Per joint: bits of force [N], torque [N m] at which it tears; first of
                                          ///< jointParticles, end.
    Buffer<gpu::uvec2> jointFilters;      ///< Bodies that touch each other once it is torn; if joints can tear.
    Buffer<uint32_t> jointReleases;       ///< Per joint: the first substep without it, or NO_SUBSTEP; if any can tear.
    Buffer<uint32_t> jointParticles;      ///< Particles that its bodies share; if joints can tear.
    Buffer<gpu::vec4> jointLoads;         ///< Per joint: its load in the substep before [N], [N m].
    Buffer<gpu::vec4> driveStiffness;     ///< Per joint of a tree, if any is driven: what drives, pins and motors add
                                          ///< to its block.
    Buffer<gpu::vec4> bodyResponses;      ///< Per body: its motion for a force on it, with what its joints move along.

private:
    void uploadTrees(const StageSetup& setup);
    void recordLoops(Recorder& recorder, const Pass& pass, uint32_t times) const;
    uint32_t treeGroups() const;
    void uploadLimits(const StageSetup& setup);
    void uploadStrengths(const StageSetup& setup);

    const gpu::StepParameters& parameters_;
    bool needed_, shared_, hasLoops_, hasLimits_, drives_, tears_, again_;
    LoopPasses loopPasses_;
    Defines variant_, loopVariant_, factorVariant_, againVariant_, rowVariant_, tearVariant_;
    Pass factor_{*this, "joint/joint_factor", factorVariant_, needed_};
    Pass refactor_{*this, "joint/joint_factor", againVariant_, again_};
    Pass refactorLast_{*this, "joint/joint_factor", with(againVariant_, "LAST"), again_&& hasLimits_};
    Pass factorLoops_{*this, "joint/loops/joint_loop_factor", loopPasses_.inPasses(rowVariant_), hasLoops_};
    Pass solveFirst_{*this, "joint/joint_solve", with(variant_, "FIRST"), needed_};
    Pass solve_{*this, "joint/joint_solve", variant_, needed_};
    Pass solveLoops_{*this, "joint/loops/joint_loop_solve", loopPasses_.inPasses(loopVariant_), hasLoops_};
    Pass tear_{*this, "joint/joint_tear", tearVariant_, tears_};
    Pass place_{*this, "joint/joint_position", {}, shared_};
};

}  // namespace knuckle
