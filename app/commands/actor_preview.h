#pragma once

#include "app/run/open_gpu.h"
#include "render/picture/image.h"
#include "sim/actor/actor.h"
#include "sim/actor/import/import.h"

namespace knuckle {

/// A picture of 1280 x 720 pixels: the actor in its rest pose from the front on the left, from its left side on the
/// right, each as large as fits; its particles with the mesh half transparent over them, its joints and their limits
/// over all.
/// @param model that it was made of, read with ImportOptions::surface.
/// @throws DeviceError without a device that can draw.
Image drawPreview(const Actor& actor, const Model& model, const CommonOptions& common);

}  // namespace knuckle
