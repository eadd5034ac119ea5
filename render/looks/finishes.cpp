#include "render/looks/finishes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/color_word.h"
#include "shared/draw_types.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// In the order of Finish. Roughnesses and the reflectances of dull things by eye; plastics and lacquers have a
/// refractive index of about 1.5, which makes 0.04.
constexpr std::array<FinishLook, 12> FINISHES{{
    {},
    {.roughness = 0.9f, .reflectance = 0.008f},
    {.roughness = 0.32f},
    {.roughness = 0.85f, .diffuseRoughness = 0.6f, .reflectance = 0.015f},
    {.roughness = 0.42f, .wrap = 0.55f},
    {.roughness = 0.62f, .diffuseRoughness = 0.35f, .reflectance = 0.025f},
    {.roughness = 0.22f, .metalness = 1.0f},
    {.roughness = 0.55f, .coat = 0.35f, .pattern = PATTERN_WOOD, .patternSize = 0.9f},
    {.roughness = 0.35f, .pattern = PATTERN_CHECKER, .patternSize = 2.0f},
    {.roughness = 0.36f, .metalness = 1.0f, .pattern = PATTERN_BRUSHED, .patternSize = 0.35f},
    {.roughness = 0.05f, .coat = 1.0f},
    {},
}};

}  // namespace

SurfaceFinish modelFinish(const SkinMaterial& material)
{
    return {Finish::Default, material.roughness, material.metalness};
}

FinishLook lookOf(const SurfaceFinish& finish)
{
    FinishLook look = FINISHES.at(static_cast<size_t>(finish.word));
    if (finish.roughness >= 0.0f) look.roughness = finish.roughness;
    if (finish.metalness >= 0.0f) look.metalness = finish.metalness;
    look.emission = finish.emission;
    return look;
}

bool hasGlass(const World& world)
{
    const auto isGlass = [](const auto& thing) { return thing.finish.word == Finish::Glass; };
    return std::ranges::any_of(world.materials, isGlass) || std::ranges::any_of(world.colliders, isGlass);
}

Finishes::Finishes(const World& world)
{
    for (const Material& material : world.materials) add(material.finish);
    for (const Collider& collider : world.colliders) add(collider.finish);
    const auto isModels = [](const Material& material) { return material.finish.word == Finish::Model; };
    if (std::ranges::any_of(world.materials, isModels)) addModels(world);
    if (finishes_.size() >= FINISH_NONE)
        throw InputError(
            fmt::format("the scene has {} finishes; at most {} can be told apart", finishes_.size(), FINISH_NONE - 1));
}

void Finishes::addModels(const World& world)
{
    bool haveMaps = false;
    for (const Skin& skin : world.skins) {
        for (const SkinMaterial& material : skin.mesh->materials) {
            add(modelFinish(material));
            haveMaps = haveMaps || material.roughnesses != NO_INDEX;
        }
    }
    if (!haveMaps) return;
    mapped_ = static_cast<uint32_t>(finishes_.size()) + 1;
    for (int step = 0; step < ROUGHNESS_STEPS; ++step)
        for (const float metalness : {0.0f, 1.0f})
            finishes_.push_back({Finish::Default, static_cast<float>(step) / (ROUGHNESS_STEPS - 1), metalness});
}

void Finishes::add(const SurfaceFinish& finish)
{
    if (finish != SurfaceFinish() && finish.word != Finish::Model &&
        std::ranges::find(finishes_, finish) == finishes_.end())
        finishes_.push_back(finish);
}

uint32_t Finishes::alphaOf(const SurfaceFinish& finish) const
{
    const auto found = std::ranges::find(finishes_, finish);
    // 0 is the ground.
    return found == finishes_.end() ? FINISH_NONE : static_cast<uint32_t>(found - finishes_.begin()) + 1;
}

uint32_t Finishes::withFinish(uint32_t colorWord, const SurfaceFinish& finish) const
{
    const uint32_t alpha = alphaOf(finish);
    return alpha == FINISH_NONE ? colorWord : (colorWord & COLOR_BITS) | alpha << 24;
}

bool Finishes::havePatterns() const
{
    return std::ranges::any_of(finishes_, [](const SurfaceFinish& f) { return lookOf(f).pattern != PATTERN_NONE; });
}

std::vector<gpu::vec4> Finishes::texels(float particleDiameter, const SurfaceFinish& ground) const
{
    std::vector<gpu::vec4> texels;
    const auto addTexels = [&](const SurfaceFinish& finish) {
        const FinishLook look = lookOf(finish);
        texels.push_back({look.roughness, look.metalness, look.coat, look.wrap});
        texels.push_back({look.diffuseRoughness, look.reflectance, static_cast<float>(look.pattern),
                          look.patternSize * particleDiameter});
        texels.push_back({look.emission, 0.0f, 0.0f, 0.0f});
    };
    addTexels(ground);
    for (const SurfaceFinish& finish : finishes_) addTexels(finish);
    return texels;
}

Defines Finishes::lightingDefines() const
{
    return empty() ? Defines{} : Defines{{"FINISHES", "1"}};
}

Defines Finishes::patternDefines() const
{
    return havePatterns() ? Defines{{"PATTERNS", "1"}} : Defines{};
}

}  // namespace knuckle
