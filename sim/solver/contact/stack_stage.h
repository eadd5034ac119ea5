#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Stacks: six or more bodies without joints whose touches form a tree, as a tower's do. All their contacts with each
/// other, with colliders and with what stands still are solved at once; other contacts are left to ContactStage.
class StackStage : public Stage {
public:
    /// Whether a world has enough bodies that may form a stack.
    static bool isNeeded(const World& world, const Layout& layout);
    explicit StackStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Finds stacks, once a step.
    void find(Recorder& recorder) const;
    /// Newton steps of each stack, from where the impulses on its bodies leave it.
    void solve(Recorder& recorder, bool first) const;
    /// Keeps the impulses of its contacts, at the end of a substep.
    void keep(Recorder& recorder) const;

    Buffer<uint32_t> stackTouches;    ///< Per body, STACK_TOUCHES: bodies that it touches.
    Buffer<uint32_t> stackRounds;     ///< Per body: the round in which it was taken off its tree; 0: no part of one.
    Buffer<uint32_t> stackMembers;    ///< Per body: how many its stack has.
    Buffer<gpu::uvec4> stackParents;  ///< Per mover: what it hangs on in its stack, or STACK_ROOT; partners of loops.
    Buffer<uint32_t> stackOrder;      ///< Bodies of stacks, parents behind their children.
    Buffer<gpu::uvec4> stackRanges;   ///< Per stack: first and end in stackOrder, number of loops.
    Buffer<gpu::uvec4> stackSizes;    ///< Work groups of stacks and of their bodies; w: how many.
    Buffer<gpu::vec4> stackBlocks;    ///< Per body, STACK_TEXELS: shared/stack_records.h.

private:
    const gpu::StepParameters& parameters_;
    bool hasColliders_;
    uint32_t treesGroup_;  ///< Threads that look for stacks.
    Pass touch_{*this, "contact/stack/stack_touch"};
    Pass trees_{*this, "contact/stack/stack_trees", {{"STACK_GROUP", std::to_string(treesGroup_) + "u"}}};
    Pass pairsFirst_{*this, "contact/stack/stack_pairs", {{"FIRST", "1"}}};
    Pass pairs_{*this, "contact/stack/stack_pairs"};
    Pass collidersFirst_{*this, "contact/stack/stack_colliders", {{"FIRST", "1"}}, hasColliders_};
    Pass colliders_{*this, "contact/stack/stack_colliders", {}, hasColliders_};
    Pass solve_{*this, "contact/stack/stack_solve"};
    Pass moveFirst_{*this, "contact/stack/stack_move", {{"FIRST", "1"}, {"BEGINS", "1"}}};
    Pass move_{*this, "contact/stack/stack_move"};
    Pass moveEnd_{*this, "contact/stack/stack_move", {{"ENDS", "1"}}};
    Pass moveAgain_{*this, "contact/stack/stack_move", {{"AGAIN", "1"}, {"BEGINS", "1"}}};
    Pass moveAgainOn_{*this, "contact/stack/stack_move", {{"AGAIN", "1"}}};
    Pass moveAgainEnd_{*this, "contact/stack/stack_move", {{"AGAIN", "1"}, {"ENDS", "1"}}};
    Pass keepPairs_{*this, "contact/stack/stack_pairs", {{"STORE", "1"}}};
    Pass keepColliders_{*this, "contact/stack/stack_colliders", {{"STORE", "1"}}, hasColliders_};
};

}  // namespace knuckle
