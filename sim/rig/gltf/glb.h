#pragma once

#include <functional>
#include <span>
#include <string>

#include "sim/rig/model.h"

namespace knuckle {

/// Generator of a file in which each skeleton is an object of its own, rather than a prop of a figure beside it.
constexpr const char* GLB_OF_OBJECTS = "knuckle, of objects";

struct GlbOptions {
    /// How far reduced keys may be off; 0: all keys are kept.
    float shiftTolerance = 0.0f;  ///< [m]
    float turnTolerance = 0.0f;   ///< [rad]
    bool apart = false;           ///< Each model is an object, even with a single bone: GLB_OF_OBJECTS.
    /// Makes a PNG file of a picture; without it, textures are left out.
    std::function<std::string(const TexturePicture&)> encode = {};
};

/// Models as one binary glTF 2.0 file: for each its skeleton, its mesh with materials if it has one, and its clips;
/// clips of one name are one animation. Bones are written as rotations and translations, so their rest poses lose any
/// scale; at most four weights a vertex are kept. The same models give the same bytes.
std::string toGlb(std::span<const Model> models, const GlbOptions& options = {});
inline std::string toGlb(const Model& model)
{
    return toGlb(std::span(&model, 1));
}

}  // namespace knuckle
