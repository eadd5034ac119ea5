#include "sim/solver/stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "shared/constants.h"
#include "sim/base/errors.h"
#include "sim/gpu/all_cores.h"
#include "sim/solver/drive/drive_upload.h"
#include "sim/solver/fluid/fluid_grid.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

void put(const Surroundings& surroundings, gpu::StepParameters& p)
{
    p.gravity = pack(surroundings.gravity, 0);
    p.wind = pack(surroundings.wind, p.wind.w);
    p.damping = std::exp(-surroundings.linearDamping * p.substepTime);
    p.maxSpeed = surroundings.maxSpeed;
}

/// The parameters that all stages start from.
gpu::StepParameters commonParameters(const World& world, const Layout& layout)
{
    const Settings& s = world.settings;
    gpu::StepParameters p{};
    p.particleCount = layout.solidCount;
    p.fluidCount = world.fluidCount;
    p.bodyCount = layout.bodyCount;
    p.moverCount = layout.moverCount();
    p.freeBodyCount = static_cast<uint32_t>(layout.freeBodies.size());
    p.jointedBodyCount = static_cast<uint32_t>(layout.jointedBodies.size());
    p.linkCount = layout.linkCount;
    p.colliderCount = layout.colliderCount;
    p.fluidFilled = world.fluidCount - world.pooledCount();
    p.assemblyCount = layout.assemblyCount;
    p.diameter = world.diameter();
    p.substeps = s.substeps;
    p.substepTime = s.timeStep / static_cast<float>(s.substeps);
    p.virtualParticles = s.virtualParticles;
    p.secondOrder = s.velocityOrder == VelocityOrder::Second ? 1u : 0u;
    put(Surroundings::of(world), p);
    return p;
}

bool actsOnParticles(const World& world)
{
    return FluidStage::isNeeded(world) || StrandStage::isNeeded(world) || SoftStage::isNeeded(world);
}

bool isByTouch(const Release& release)
{
    return release.cause == ReleaseCause::Touch;
}

bool filtersAny(const Body& body)
{
    return !body.filtered.empty();
}

/// Rows of all kinds of constraints that act on bodies through the channel.
RowPlan planRows(const World& world, const Layout& layout)
{
    RowPlan rows;
    JointStage::reserveRows(rows, world, layout);
    reserveDriveRows(rows, world);
    MotorStage::reserveRows(rows, world, layout);
    GearStage::reserveRows(rows, world, layout);
    rows.place(layout.bodyCount);
    return rows;
}

/// "_lists" for {{"LISTS", "1"}}.
std::string variantName(const Defines& variant)
{
    std::string name;
    for (const auto& [define, value] : variant) {
        name += '_';
        for (const char c : define) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return name;
}

}  // namespace

Stages::Stages(const Gpu& gpu, const World& world, const Shuffle& shuffle, const std::optional<ListRoom>& room)
    : gpu_(gpu), world_(world), layout(world), rows(planRows(world, layout)),
      parameters(commonParameters(world, layout)), setup_{gpu, world, layout, rows, parameters}, particles(setup_),
      colliders(setup_), search(setup_), contacts(setup_), bodies(setup_, actsOnParticles(world)), joints(setup_)
{
    if (AnimationStage::isNeeded(world)) animations.emplace(setup_);
    if (DriveStage::isNeeded(world)) drives.emplace(setup_);
    if (MotorStage::isNeeded(world)) motors.emplace(setup_);
    if (GearStage::isNeeded(world)) gears.emplace(setup_);
    if (ForceStage::isNeeded(world)) forces.emplace(setup_);
    if (ReleaseStage::isNeeded(world)) releases.emplace(setup_);
    if (RestitutionStage::isNeeded(world)) restitution.emplace(setup_);
    if (SleepStage::isNeeded(world.settings)) sleep.emplace(setup_);
    if (StackStage::isNeeded(world, layout)) stacks.emplace(setup_);
    if (SoftStage::isNeeded(world)) soft.emplace(setup_);
    if (StrandStage::isNeeded(world)) strands.emplace(setup_);
    if (FluidStage::isNeeded(world)) fluids.emplace(setup_);
    if (ViscosityStage::isNeeded(world)) viscosity.emplace(setup_);
    if (FluidWatchStage::isNeeded(world)) fluidWatch.emplace();
    if (FoamStage::isNeeded(world)) foam.emplace(setup_);
    if (FormStage::isNeeded(world)) forms.emplace(setup_);
    if (EmitterStage::isNeeded(world)) emitters.emplace(setup_);
    if (world.settings.solver == SolverKind::Paper) paper.emplace(setup_);
    if (ShownStage::isNeeded(world)) shown.emplace(setup_);
    std::vector<Stage*> stages = all();
    if (shuffle) shuffle(stages);
    for (Stage* stage : stages) stage->upload(setup_);
    if (room) {
        parameters.candidateCapacity = room->candidates;
        parameters.pairCapacity = parameters.colliderPairCapacity = room->pairs;
        parameters.fluidSlots = room->neighbours;
    }
    for (Stage* stage : stages) stage->makeLists();
    uploadParameters();
    const gpu::uvec4 slots{groupsFor(parameters.particleCount + parameters.fluidFilled), 1, 1, 0};
    dispatches.write(&slots, sizeof slots, DISPATCH_SLOTS * sizeof slots);
}

std::vector<Stage*> Stages::all()
{
    std::vector<Stage*> stages{&particles, &colliders, &search, &contacts, &bodies, &joints, &stateHash};
    const auto add = [&](auto& stage) {
        if (stage) stages.push_back(&*stage);
    };
    add(animations);
    add(drives);
    add(motors);
    add(gears);
    add(forces);
    add(releases);
    add(restitution);
    add(sleep);
    add(stacks);
    add(soft);
    add(strands);
    add(fluids);
    add(viscosity);
    add(fluidWatch);
    add(foam);
    add(forms);
    add(emitters);
    add(paper);
    add(shown);
    return stages;
}

BufferTable Stages::table()
{
    BufferTable table;
    for (Stage* stage : all()) stage->addBuffers(table);
    table.add(Lifetime::State, step, dispatches);
    table.add("countersBlock", counters, elementType<gpu::Counters>(), Lifetime::State);
    return table;
}

Defines Stages::worldDefines() const
{
    const Settings& s = world_.settings;
    return definesOf({{"HOUSEHOLDER", s.rotation == RotationMethod::Householder},
                      {"HIGHAM", s.rotation == RotationMethod::Higham},
                      {"MASS_SCALING", s.massScaling > 0.0f},
                      {"ROUNDS", layout.hasRounds},
                      {"GRAINS", layout.hasGrains},
                      {"SLEEP", sleep.has_value()},
                      {"STACKS", stacks.has_value()},
                      {"ROPES", strands && strands->touchesColliders()},
                      {"FREEZE", s.freeze > 0.0f},
                      {"PUPPETS", drives.has_value()},
                      {"TOUCHES", std::ranges::any_of(world_.releases, isByTouch)},
                      {"POOL", emitters.has_value()},
                      {"FORCES", forces.has_value()},
                      {"GRIDS", layout.hasGrids},
                      {"BOX_REGIONS", layout.hasBoxRegions},
                      {"ROUND_REGIONS", layout.hasRoundRegions},
                      {"MOVING", !world_.colliderMotions.empty()},
                      {"RELEASES", releases.has_value()},
                      {"FILTERS", std::ranges::any_of(world_.bodies, filtersAny)},
                      {"GRID_HASH", s.grid == GridKind::Hash},
                      {"SOFTWARE_DRIVER", gpu_.device().software}});
}

void Stages::load(const std::vector<Stage*>& stages)
{
    const BufferTable buffers = table();
    const Defines common = worldDefines();
    std::vector<Stage::Pass*> passes;
    for (const Stage* stage : stages)
        std::ranges::copy_if(stage->passes(), std::back_inserter(passes),
                             [](const Stage::Pass* pass) { return pass->program() == 0; });
    // Stages that few worlds need have the longest kernels; the last to begin should be short.
    std::ranges::reverse(passes);
    makeOnAllCores(gpu_, passes.size(), [&](size_t i, const Gpu& gpu) {
        passes[i]->load([&](const char* path, const Defines& variant) {
            Defines defines = common;
            defines.insert(defines.end(), variant.begin(), variant.end());
            return Kernel(gpu, buffers, std::string("sim/") + path + ".comp", defines, variantName(variant),
                          gridRenames(variant));
        });
        if (gpu.device().software) passes[i]->compile();
    });
    checkSizes();
}

void Stages::checkSizes()
{
    const uint64_t count = uint64_t{parameters.particleCount} + parameters.fluidCount;
    const uint64_t most = static_cast<uint64_t>(gpu_.limits().workGroupCountX) * GROUP_SIZE;
    if (count > most)
        throw DeviceError(
            fmt::format("{}: {} particles, and the device allows {} threads; use fewer particles or another "
                        "--device",
                        gpu_.device().name, count, most));
    for (const Stage* stage : all())
        for (const Stage::Pass* pass : stage->passes()) pass->checkSizes(gpu_);
}

Recorder Stages::recorder(KernelTimer& timer) const
{
    return {timer, dispatches, gpu_.device().software ? EmptyPasses::LeaveOut : EmptyPasses::Dispatch};
}

StagesState Stages::save()
{
    return {parameters, table().saveState()};
}

void Stages::load(const StagesState& state)
{
    parameters = state.parameters;
    for (Stage* stage : all()) {
        stage->adapt(parameters);
        stage->makeLists();
    }
    table().loadState(state.buffers);
}

void Stages::surround(const Surroundings& surroundings)
{
    put(surroundings, parameters);
    for (Stage* stage : all()) stage->adapt(parameters);
    uploadParameters();
}

void Stages::grow(const gpu::Counters& c)
{
    for (Stage* stage : all()) stage->reserve(parameters, c);
    for (Stage* stage : all()) stage->makeLists();
    checkSizes();
    uploadParameters();
}

}  // namespace knuckle
