#pragma once

#include <cstdint>
#include <vector>

#include "shared/gpu_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/gpu.h"
#include "sim/world/world.h"

namespace knuckle {

/// What a finish is made of.
struct FinishLook {
    float roughness = 0.5f;         ///< Of what it mirrors, 0 ... 1: the root of Trowbridge and Reitz's alpha.
    float metalness = 0.0f;         ///< 0 ... 1.
    float coat = 0.0f;              ///< Share covered by clear lacquer, 0 ... 1.
    float wrap = 0.0f;              ///< How far light goes round inside, 0 ... 1.
    float diffuseRoughness = 0.0f;  ///< Of Oren and Nayar, 0 ... 1.
    float reflectance = 0.04f;      ///< Of what is no metal, straight on.
    uint32_t pattern = 0;           ///< PATTERN_*
    float patternSize = 1.0f;       ///< [particle diameters]
    float emission = 0.0f;          ///< See SurfaceFinish.
};

/// The finish that a model gives a part of its skin; the default where it says nothing.
SurfaceFinish modelFinish(const SkinMaterial& material);
/// The look of a finish, with what differs from its word.
FinishLook lookOf(const SurfaceFinish& finish);

/// Whether light goes through anything that is drawn of a world.
bool hasGlass(const World& world);

/// The finishes of a world, as surface words name them: in the order in which materials and colliders, then skins have
/// them.
class Finishes {
public:
    /// @throws InputError for more than a surface word can tell apart.
    explicit Finishes(const World& world);

    /// What a surface word has in place of its alpha, above its colour.
    uint32_t alphaOf(const SurfaceFinish& finish) const;
    /// A colour word with a finish; 0, which stands for the colour of a speed, stays it unless there is a finish.
    uint32_t withFinish(uint32_t colorWord, const SurfaceFinish& finish) const;
    /// Where a picture says how rough skins are: what surface words have for the least roughness of what is no metal.
    /// The others follow, metals after every roughness, of ROUGHNESS_STEPS. 0 where no skin has such a picture.
    uint32_t mappedAlpha() const { return mapped_; }
    bool empty() const { return finishes_.empty(); }
    /// Whether any of them has a pattern.
    bool havePatterns() const;
    /// FINISH_TEXELS each, that of the ground first.
    std::vector<gpu::vec4> texels(float particleDiameter, const SurfaceFinish& ground) const;
    /// For shaders that ask for finishes, or for their patterns.
    Defines lightingDefines() const;
    Defines patternDefines() const;

private:
    void add(const SurfaceFinish& finish);
    void addModels(const World& world);

    std::vector<SurfaceFinish> finishes_;
    uint32_t mapped_ = 0;
};

}  // namespace knuckle
