#pragma once

#include <functional>
#include <optional>

#include "sim/solver/animation/animation_stage.h"
#include "sim/solver/body/body_stage.h"
#include "sim/solver/contact/collider_stage.h"
#include "sim/solver/contact/contact_stage.h"
#include "sim/solver/contact/stack_stage.h"
#include "sim/solver/drive/drive_stage.h"
#include "sim/solver/drive/motor_stage.h"
#include "sim/solver/emitter/emitter_stage.h"
#include "sim/solver/fluid/fluid_stage.h"
#include "sim/solver/fluid/fluid_watch_stage.h"
#include "sim/solver/fluid/foam_stage.h"
#include "sim/solver/fluid/form_stage.h"
#include "sim/solver/fluid/viscosity_stage.h"
#include "sim/solver/forces/force_stage.h"
#include "sim/solver/joint/gear_stage.h"
#include "sim/solver/joint/joint_stage.h"
#include "sim/solver/list_room.h"
#include "sim/solver/paper/paper_stage.h"
#include "sim/solver/particle/particle_stage.h"
#include "sim/solver/particle/state_hash_stage.h"
#include "sim/solver/release/release_stage.h"
#include "sim/solver/restitution/restitution_stage.h"
#include "sim/solver/search/search_stage.h"
#include "sim/solver/shown/shown_stage.h"
#include "sim/solver/sleep/sleep_stage.h"
#include "sim/solver/soft/soft_stage.h"
#include "sim/solver/stages_state.h"
#include "sim/solver/strand/strand_stage.h"
#include "sim/world/forces/surroundings.h"

namespace knuckle {

/// All rooms of a world's solver and what they share: everything that simulates, on the GPU, filled once from the
/// World. An optional stage exists only if the world needs it.
class Stages {
public:
    /// Changes the order of uploading, for tests: the order must not matter.
    using Shuffle = std::function<void(std::vector<Stage*>&)>;

    /// Uploads the world; compiles nothing yet. @param world must outlive it.
    /// @param room first capacities of lists, for tests: bits do not depend on them.
    Stages(const Gpu& gpu, const World& world, const Shuffle& shuffle = {}, const std::optional<ListRoom>& room = {});

    /// Compiles the kernels of all stages, on all cores. @throws DeviceError, with the number, also when the device's
    /// limits are too small for the world.
    void load() { load(all()); }
    /// Only those of `stateHash`, which is all that a picture of the start needs.
    void loadHash() { load({&stateHash}); }
    /// Gives every list the room that kernels asked for. Lists keep their contents. @throws DeviceError as load().
    void grow(const gpu::Counters& counters);
    /// From the next step on.
    void surround(const Surroundings& surroundings);
    /// What a run carries from step to step. Stalls until the GPU is done.
    StagesState save();
    /// @throws std::logic_error if the state is not from stages of the same World.
    void load(const StagesState& state);
    /// The buffers of all stages, with the names that kernels use.
    BufferTable table();
    /// Of passes of these stages; leaves out empty ones on a software driver.
    Recorder recorder(KernelTimer& timer) const;
    /// Uploads the parameters again after a change: for tests.
    void uploadParameters() { step.upload(std::span<const gpu::StepParameters>(&parameters, 1)); }

private:
    std::vector<Stage*> all();
    /// Compiles kernels that are not yet compiled.
    void load(const std::vector<Stage*>& stages);
    /// That the device can bind what the loaded kernels ask for.
    void checkSizes();
    /// Defines that all kernels of this world are compiled with.
    Defines worldDefines() const;

    const Gpu& gpu_;
    const World& world_;

public:
    Layout layout;
    RowPlan rows;
    gpu::StepParameters parameters{};                             ///< The host's copy of `step`.
    Buffer<gpu::StepParameters> step{"step", 1};                  ///< Everything a step needs to know.
    Buffer<gpu::Counters> counters{"counters", 1};                ///< Written by kernels, read once a frame.
    Buffer<gpu::uvec4> dispatches{"dispatches", DISPATCH_COUNT};  ///< DISPATCH_*: work groups that kernels decide.

private:
    StageSetup setup_;

public:
    ParticleStage particles;
    ColliderStage colliders;
    SearchStage search;
    ContactStage contacts;
    BodyStage bodies;
    JointStage joints;
    StateHashStage stateHash;
    std::optional<AnimationStage> animations;
    std::optional<DriveStage> drives;
    std::optional<MotorStage> motors;
    std::optional<GearStage> gears;
    std::optional<ForceStage> forces;
    std::optional<ReleaseStage> releases;
    std::optional<RestitutionStage> restitution;
    std::optional<SleepStage> sleep;
    std::optional<StackStage> stacks;
    std::optional<SoftStage> soft;
    std::optional<StrandStage> strands;
    std::optional<FluidStage> fluids;
    std::optional<ViscosityStage> viscosity;
    std::optional<FluidWatchStage> fluidWatch;
    std::optional<FoamStage> foam;
    std::optional<FormStage> forms;
    std::optional<EmitterStage> emitters;
    std::optional<PaperStage> paper;
    std::optional<ShownStage> shown;
};

}  // namespace knuckle
