#pragma once

#include "app/run/open_gpu.h"
#include "render/picture/image.h"
#include "sim/rig/actor.h"
#include "sim/rig/figure.h"

namespace knuckle {

/// A picture of 1280 x 720 pixels: the actor in its rest pose from the front on the left, from its left side on the
/// right, each as large as possible; its particles with the mesh half transparent over them, and its joints and limits
/// on top.
/// @param figure that the actor was made of, from a model read with ImportOptions::surface.
/// @throws DeviceError without a device that can draw.
Image drawPreview(const Actor& actor, const Figure& figure, const CommonOptions& common);

}  // namespace knuckle
