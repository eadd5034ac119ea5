#pragma once

#include "sim/solver/fluid/slot_stage.h"
#include "sim/solver/measure/measure.h"
#include "sim/solver/particle_view.h"

namespace knuckle {

/// Fluids: position based fluids (Macklin and Mueller 2013) on the particles that come after all others. They are not
/// movers; their pressure on solids goes through BodyStage::particleImpulses. A slot is a particle's place in the
/// order of the cells of the fluids' own grid.
class FluidStage : public SlotStage {
public:
    static bool isNeeded(const World& world) { return world.fluidCount > 0; }
    /// @throws DeviceError when the device's limits are too small for the lists of neighbours.
    explicit FluidStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void adapt(gpu::StepParameters& parameters) override;
    void addBuffers(BufferTable& table) override;
    void reserve(gpu::StepParameters& parameters, const gpu::Counters& counters) const override;

    /// Makes the buffers of slots anew, with the capacities of the parameters.
    void makeLists() override;
    /// Once, before the first step: a lattice that fills a tank is too dense at its walls and at solids. This spreads
    /// it without gaining speed; within a step, the same displacement would become speed. It repeats until no particle
    /// would gain speed, and stalls to read that from the GPU.
    void relax(Recorder& recorder);
    /// Once a step: finds neighbours; viscosity and vorticity confinement.
    void beginStep(Recorder& recorder) const;
    /// One iteration of pressures, after the movers have been predicted. Afterwards fluid particles are at their
    /// positions of the substep's end.
    /// @param index of the substep in its step
    void substep(Recorder& recorder, uint32_t index) const;
    /// Fluid particles with their densities in the last substep over that at rest, in no particular order. Stalls until
    /// the GPU is done.
    std::vector<std::pair<uint32_t, float>> densities() const;
    /// Names the buffers from which densities and pressures are drawn.
    void show(ParticleView& view) const;

    Buffer<gpu::vec4> fluidSearchPositions;  ///< Per particle: where it was when neighbours were found.
    Buffer<gpu::uvec2> fluidParticleCells;   ///< Cell, arrival in it.
    Buffer<uint32_t> fluidCellCounts, fluidCellSums, fluidCellStarts, fluidCellMembers;  ///< As of SearchStage.
    Buffer<uint32_t> fluidSorted;                           ///< Per slot: its position, packed (packed_positions.glsl).
    Buffer<uint32_t> fluidNearSolids;                       ///< Bits of cells: near_solids.glsl.
    Buffer<uint32_t> slotParticles, particleSlots;          ///< Each other's inverse.
    Buffer<gpu::uvec2> slotCounts;                          ///< Fluid and solid neighbours.
    Buffer<gpu::uvec4> slotNeighbours;                      ///< fluidSlots a slot (fluid_slots.glsl).
    Buffer<uint32_t> slotColliders;                         ///< Bits of nearby colliders.
    Buffer<uint32_t> freeSlots, walledSlots, coveredSlots;  ///< Slots of fluid: slot_lists.glsl.
    Buffer<gpu::uvec4> slotListSizes;                       ///< Of these lists: slot_lists.h.
    Buffer<gpu::vec4> fluidMaterials;                       ///< Per material: smoothing, tension.
    Buffer<uint32_t> slotMaterials;                         ///< Index into World::materials.
    Buffer<gpu::vec4> slotVelocities;                       ///< When neighbours were found [m/s]; w: smoothing.
    Buffer<gpu::uvec4> slotGradients;                       ///< SlotGradient (slot_values.glsl).
    Buffer<gpu::vec4> slotPositions;                        ///< Predicted [m]; w: mass [kg].
    Buffer<gpu::vec4> slotMoves;                            ///< Since the last substep [m]: SlotMove.
    Buffer<gpu::vec4> slotShapes;                           ///< Two each: fetchSlotShape() (slot_pressures.glsl).
    Buffer<gpu::uvec4> slotPressures;                       ///< Two each: SlotPressure.
    Buffer<gpu::vec4> slotSolidImpulses;                    ///< What solids gave it in the substep [kg m].
    Buffer<gpu::vec4> fluidPasts;                           ///< Per particle: FluidPast (fluid_past.glsl).
    Buffer<gpu::vec4> slotVorticities;                      ///< [1/s]; w: its length.
    Buffer<uint32_t> fluidLargestPush;        ///< One: largest push of a pass before the first step [m], as bits
                                              ///< of a float.
    Buffer<gpu::vec4> slotWalls, slotSolids;  ///< Gradients of the density from walls and solids.
    Buffer<gpu::vec4> slotCovers;             ///< SlotCover (slot_covers.glsl).
    Buffer<gpu::vec4> particleWets;           ///< Three each: body_wets.glsl.
    Buffer<float> bodySeals;                  ///< The same.

private:
    void list(Recorder& recorder) const;
    /// Lists anew, with all where it is now.
    void listInPlace(Recorder& recorder) const;
    void makeRoom(Recorder& recorder);
    void settle(Recorder& recorder);
    /// Kernels for the slots of each list (slot_lists.glsl).
    void perList(Recorder& recorder, const Kernel& free, const Kernel& walled, const Kernel& covered) const;
    /// With SOLIDS if the world has any.
    Defines ofSolids(Defines others = {}) const;
    Defines densityOf(const char* list) const;
    Defines pressureOf(const char* list) const;

    bool confines_, hasTension_, hasColliders_, hasSolids_;
    bool seals_;    ///< Bodies may lie on colliders.
    bool settles_;  ///< Weight acts, and no fluid is so thick that what hangs over stays.
    Pass searchPosition_{*this, "fluid/fluid_search_position", ofSolids()};
    Pass nearSolids_{*this, "fluid/fluid_near_solids", {{"FLUIDS", "1"}}, hasSolids_};
    Pass count_{*this, "common/grid/grid_count", {{"FLUIDS", "1"}}};
    Pass sum_{*this, "common/grid/scan_sum", {{"FLUIDS", "1"}}};
    Pass start_{*this, "common/grid/grid_start", {{"FLUIDS", "1"}}};
    Pass scatter_{*this, "common/grid/grid_scatter", {{"FLUIDS", "1"}}};
    Pass order_{*this, "fluid/fluid_order", {{"FLUIDS", "1"}}};
    Pass find_{*this, "fluid/fluid_find", ofSolids({{"FLUIDS", "1"}})};
    Pass colliderNear_{*this, "fluid/walls/fluid_collider_near"};
    Pass slotLists_{*this, "fluid/walls/fluid_slot_lists"};
    Pass gather_{*this, "fluid/fluid_gather"};
    Pass gradient_{*this, "fluid/fluid_velocity_gradient"};
    Pass viscosity_{*this, "fluid/fluid_viscosity"};
    Pass vorticity_{*this, "fluid/fluid_vorticity", {}, confines_};
    Pass confinement_{*this, "fluid/fluid_vorticity_confinement", {}, confines_};
    Pass predict_{*this, "fluid/fluid_predict"};
    Pass predictSolid_{*this, "fluid/fluid_predict_solid"};
    Pass shape_{*this, "fluid/pressure/fluid_shape"};
    Pass densityFree_{*this, "fluid/pressure/fluid_density", densityOf("FREE")};
    Pass densityWalled_{*this, "fluid/pressure/fluid_density", densityOf("WALLED"), hasColliders_};
    Pass densityCovered_{*this, "fluid/pressure/fluid_density", densityOf("COVERED"), hasSolids_};
    Pass pressureFree_{*this, "fluid/pressure/fluid_pressure", pressureOf("FREE")};
    Pass pressureWalled_{*this, "fluid/pressure/fluid_pressure", pressureOf("WALLED"), hasColliders_};
    Pass pressureCovered_{*this, "fluid/pressure/fluid_pressure", pressureOf("COVERED"), hasSolids_};
    Pass coupling_{*this, "fluid/pressure/fluid_solid_coupling", seals_ ? Defines{{"SEALS", "1"}} : Defines{}};
    Pass bodySeal_{*this, "fluid/pressure/fluid_body_seal", {}, seals_};
    Pass seal_{*this, "fluid/pressure/fluid_seal", {}, seals_};
    Pass predictRelaxed_{*this, "fluid/fluid_predict", {{"RELAX", "1"}}};
    Pass predictSolidRelaxed_{*this, "fluid/fluid_predict_solid", {{"RELAX", "1"}}};
    Pass densityRelaxed_{*this, "fluid/pressure/fluid_density", {{"RELAX", "1"}}};
    Pass pressureRelaxed_{*this, "fluid/pressure/fluid_pressure", {{"RELAX", "1"}}};
    Pass densitySettled_{*this, "fluid/pressure/fluid_density", {{"SETTLE", "1"}}, settles_};
    Pass pressureSettled_{*this, "fluid/pressure/fluid_pressure", {{"SETTLE", "1"}}, settles_};
};

}  // namespace knuckle
