#pragma once

#include "render/settings.h"
#include "render/view/camera.h"
#include "shared/frame_types.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// What stays the same from frame to frame.
gpu::FrameInput frameInput(const World& world, const RenderSettings& settings, const SceneExtent& extent,
                           const Camera& camera);
/// Puts in what a view says of its particles.
void describeParticles(gpu::FrameInput& input, const ParticleView& view);
/// Puts in where the camera is at `time` [s], `passed` seconds after it looked last; below 0: it has not looked yet.
void placeCamera(gpu::FrameInput& input, const CameraAim& aim, float passed);

}  // namespace knuckle
