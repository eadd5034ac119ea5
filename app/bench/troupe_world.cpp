#include "app/bench/troupe_world.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/bench/bench_worlds.h"
#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/clips/body_clip.h"
#include "sim/rig/clips/clip_ranges.h"
#include "sim/rig/skin/skin_mesh.h"
#include "sim/world/builder/builder.h"

namespace knuckle {

namespace {

constexpr float DIAMETER = 0.047f;          // 643 particles and 18 bodies of the project's figure
constexpr uint32_t COLUMNS = 5, ROWS = 10;  // of a layer
constexpr float COLUMN_WIDTH = 0.76f, ROW_DEPTH = 0.36f, LAYER_HEIGHT = 2.0f, LIFT = 0.3f;  // [m]
const char* const CLIP = "walk";

constexpr float CROWD_SPACING = 1.3f;  // [m]

/// An actor with the clip that it plays.
struct Performer {
    Actor actor;
    BodyClip motion;
};

Performer performerOf(const Model& model, const std::string& file, const ActorOptions& options)
{
    const auto clip = std::ranges::find(model.clips, CLIP, &Clip::name);
    if (clip == model.clips.end())
        throw InputError(fmt::format("{}: has no clip \"{}\"; give another --model", file, CLIP));
    Actor actor = makeActor(model, options);
    BodyClip motion = ownClip(actor, model, *clip).clip;
    holdWithinLimits(actor, motion);
    allow(actor, needsOf(actor, motion));
    return {std::move(actor), std::move(motion)};
}

uint32_t addFigureMaterial(WorldBuilder& builder)
{
    Material material;
    material.name = "figure";
    return builder.addMaterial(material);
}

/// The place of a figure: layer after layer, row after row, about the middle of the box.
Pose poseOf(uint32_t index)
{
    const uint32_t layer = index / (COLUMNS * ROWS), column = index % COLUMNS, row = index / COLUMNS % ROWS;
    return {{COLUMN_WIDTH * fromMiddle(column, COLUMNS), LIFT + LAYER_HEIGHT * static_cast<float>(layer),
             ROW_DEPTH * fromMiddle(row, ROWS)},
            Quaternionf::Identity()};
}

/// The part of its clip that a figure begins with: those of a column are in step, since rows are nearer than a stride.
float phaseOf(uint32_t index)
{
    const uint32_t layer = index / (COLUMNS * ROWS);
    return static_cast<float>((2 * index + layer) % COLUMNS) / COLUMNS;
}

}  // namespace

World troupeWorld(uint32_t actorCount, float releaseTime, const std::string& file, const Settings& settings)
{
    ActorOptions options;
    options.voxels.diameter = DIAMETER;
    options.articulation.limited = settings.solver == SolverKind::Impulse;
    auto [actor, motion] = performerOf(importModel(file, {}), file, options);
    WorldBuilder builder(DIAMETER / 2, settings);
    const uint32_t material = addFigureMaterial(builder);
    addBenchBox(builder);
    const float length = motion.duration();
    ClipPlay play{.clip = builder.addClip(std::move(motion)), .inPlace = true};
    for (uint32_t i = 0; i < actorCount; ++i) {
        actor.name = fmt::format("actor {}", i);
        const uint32_t object = addActor(builder, actor, material, poseOf(i));
        play.start = length * phaseOf(i);
        builder.animate({object, poseOf(i), pivotOf(actor), {play}});
        const Object& added = builder.world().objects[object];
        for (uint32_t b = 0; b < added.bodyCount; ++b) builder.releaseBody(added.bodyStart + b, releaseTime);
    }
    return builder.build();
}

World crowdWorld(uint32_t actorCount, const std::string& file)
{
    const Model model = importModel(file, {.surface = true});
    auto [actor, motion] = performerOf(model, file, {});
    const auto skin = std::make_shared<const SkinMesh>(makeSkinMesh(actor, model));
    WorldBuilder builder(actor.diameter / 2);
    const uint32_t material = addFigureMaterial(builder);
    builder.addCollider({});
    const ClipPlay play{.clip = builder.addClip(std::move(motion)), .inPlace = true};
    std::vector<uint32_t> objects;
    for (uint32_t i = 0; i < actorCount; ++i) {
        const uint32_t column = i % COLUMNS, row = i / COLUMNS;
        const Pose pose{{CROWD_SPACING * static_cast<float>(column), LIFT, -CROWD_SPACING * static_cast<float>(row)},
                        Quaternionf::Identity()};
        objects.push_back(addActor(builder, actor, material, pose));
        builder.animate({objects.back(), pose, pivotOf(actor), {play}});
    }
    builder.addSkin(skin, objects, SkinUse::Hide);
    return builder.build();
}

}  // namespace knuckle
