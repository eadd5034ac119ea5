#pragma once

#include "render/settings.h"
#include "render/view/camera.h"
#include "shared/frame_types.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// Values that are the same in all frames.
gpu::FrameInput frameInput(const World& world, const RenderSettings& settings, const SceneExtent& extent);
/// Adds a view's values about its particles.
void describeParticles(gpu::FrameInput& input, const ParticleView& view, bool hasSurfaces);
/// Adds the camera's place, `passed` seconds after its last look; below 0: its first look.
void placeCamera(gpu::FrameInput& input, const Camera& camera, const CameraAim& aim, float passed);
/// Adds where one of the draws of a frame sees from, after placeCamera(). @param draw of drawsOf(settings).
void placeLens(gpu::FrameInput& input, const RenderSettings& settings, const CameraAim& aim, uint32_t draw);

}  // namespace knuckle
