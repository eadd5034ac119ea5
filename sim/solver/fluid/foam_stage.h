#pragma once

#include "sim/solver/fluid/slot_stage.h"

namespace knuckle {

/// Foam, spray and bubbles (Ihmsen et al. 2012) that fluids make where they break: points of their own, once a step,
/// which nothing of the simulation depends on. They stand in a ring (shaders/sim/fluid/foam/foam_points.glsl).
class FoamStage : public SlotStage {
public:
    /// For worlds with a fluid that makes any (FluidLook::foam) and is thin.
    static bool isNeeded(const World& world) { return capacity(world) > 0; }
    /// Most points of a world; 0: it makes none.
    static uint32_t capacity(const World& world);
    explicit FoamStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Moves all points, and makes those of the step. Slots must be those that the step has listed.
    void endStep(Recorder& recorder) const;

    Buffer<gpu::vec4> foamPlaces;           ///< Per point: place [m]; w: opacity, 0 where there is none.
    Buffer<gpu::vec4> foamMoves;            ///< Per point: velocity [m/s]; w: how long it still lives [s].
    Buffer<gpu::uvec4> foamRing;            ///< RingState and sizes of dispatches (foam_points.glsl).
    Buffer<float> foamRates;                ///< Per material: FluidLook::foam, 0 of thick ones.
    Buffer<gpu::vec4> foamFlows;            ///< Per slot: velocity at the step's end [m/s]; w: 0 of solids.
    Buffer<gpu::vec4> foamFacings;          ///< Per slot: the way out of the fluid; w: how little is on that side.
    Buffer<uint32_t> foamBirths, foamSums;  ///< Per slot: points that it makes; per chunk: those before it.
    Buffer<uint32_t> foamParents;           ///< Per point of the step: the slot that makes it.

private:
    Pass surface_{*this, "fluid/foam/foam_surface"};
    Pass births_{*this, "fluid/foam/foam_births"};
    Pass sum_{*this, "common/grid/scan_sum", {{"FLUIDS", "1"}, {"FOAM", "1"}}};
    Pass ring_{*this, "fluid/foam/foam_ring"};
    Pass list_{*this, "fluid/foam/foam_list"};
    Pass advance_{*this, "fluid/foam/foam_advance", {{"FLUIDS", "1"}}};
    Pass birth_{*this, "fluid/foam/foam_birth"};
};

}  // namespace knuckle
