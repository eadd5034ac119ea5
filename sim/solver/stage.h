#pragma once

#include "shared/counters.h"
#include "shared/step_parameters.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/layout/layout.h"
#include "sim/solver/layout/row_plan.h"

namespace knuckle {

/// What stages are made from.
struct StageSetup {
    const Gpu& gpu;
    const World& world;
    const Layout& layout;
    const RowPlan& rows;
    gpu::StepParameters& parameters;  ///< Each stage sets its own; uploaded when all are made.
};

/// The names of the true entries, each defined as 1.
inline Defines definesOf(std::initializer_list<std::pair<const char*, bool>> names)
{
    Defines defines;
    for (const auto& [name, needed] : names)
        if (needed) defines.push_back({name, "1"});
    return defines;
}

/// A variant with one more define.
inline Defines with(Defines variant, const char* define)
{
    variant.push_back({define, "1"});
    return variant;
}

/// What becomes of a pass for which earlier kernels have decided on no work group at all. A software driver has run
/// those already, and to look at a size in its memory costs less than to dispatch nothing: a step of a dancing figure
/// takes 0.6 of the time. On a GPU the host would have to wait.
enum class EmptyPasses { Dispatch, LeaveOut };

/// Records the passes of a step.
class Recorder {
public:
    /// @param sizes Stages::dispatches.
    Recorder(KernelTimer& timer, const RawBuffer& sizes, EmptyPasses empty)
        : timer_(timer), sizes_(sizes), empty_(empty)
    {
    }

    /// One thread per element; does nothing for zero elements.
    void perElement(const Kernel& kernel, uint64_t elements)
    {
        if (elements > 0) kernel.dispatch(timer_, groupsFor(elements));
    }
    void groups(const Kernel& kernel, uint32_t count)
    {
        if (count > 0) kernel.dispatch(timer_, count);
    }
    /// As many work groups as earlier kernels have decided. @param slot DISPATCH_*.
    void decided(const Kernel& kernel, uint32_t slot) { decided(kernel, sizes_, slot); }
    /// The same, of sizes that a stage keeps itself.
    void decided(const Kernel& kernel, const RawBuffer& sizes, uint32_t slot)
    {
        if (empty_ == EmptyPasses::LeaveOut) {
            uint32_t groups = 0;
            sizes.read(&groups, sizeof groups, sizeof(gpu::uvec4) * slot);
            if (groups == 0) return;
        }
        kernel.dispatchIndirect(timer_, sizes, slot);
    }

private:
    KernelTimer& timer_;
    const RawBuffer& sizes_;
    EmptyPasses empty_;
};

/// A room of the solver: its buffers, filled from the World and its Layout alone, its kernels, and the passes that it
/// records. It must not move in memory, since kernels refer to its buffers.
class Stage {
public:
    Stage() = default;
    virtual ~Stage() = default;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Fills its buffers and sets its parameters, once; the order of stages does not matter. Lists come later.
    virtual void upload(const StageSetup& setup) = 0;
    /// When gravity, wind or damping in the parameters are others than in the world: sets what depends on them.
    virtual void adapt(gpu::StepParameters&) {}
    /// Gives its lists the capacities of the parameters; lists that are state keep their contents.
    virtual void makeLists() {}
    /// After an overflow: raises the parameters to the room that kernels asked for.
    virtual void reserve(gpu::StepParameters&, const gpu::Counters&) const {}
    /// Adds its buffers under the names by which kernels know them.
    virtual void addBuffers(BufferTable& table) = 0;

    /// A kernel of a stage, named once.
    class Pass : public Kernel {
    public:
        /// @param path below shaders/sim, without its ending. @param variant defines, by which it is also named.
        /// @param needed false for a world that never runs it.
        Pass(Stage& owner, const char* path, Defines variant = {}, bool needed = true)
            : path_(path), variant_(std::move(variant))
        {
            if (needed) owner.passes_.push_back(this);
        }
        void load(const LoadKernel& load) { Kernel::operator=(load(path_, variant_)); }

    private:
        const char* path_;
        Defines variant_;
    };

    /// Its kernels, to be loaded when all stages have added their buffers.
    const std::vector<Pass*>& passes() const { return passes_; }

protected:
    /// Lists of the current search and of the previous one share one buffer.
    static constexpr size_t HALVES = 2;

private:
    std::vector<Pass*> passes_;
};

}  // namespace knuckle
