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
/// Adds the camera's place at `time` of the film [s], `passed` seconds after its last look; below 0: its first look.
void placeCamera(gpu::FrameInput& input, const Camera& camera, double time, float passed);

}  // namespace knuckle
