#pragma once

#include <cstdint>
#include <vector>

#include "render/settings.h"
#include "render/view/camera.h"
#include "shared/frame_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// The particles that the cameras of a film frame, look at or have sharp, as sets with a bit each.
struct FramedSets {
    std::vector<uint32_t> bits = {};   ///< Per camera: its set's bit; 0: it goes by all particles.
    std::vector<uint32_t> sharp = {};  ///< The same of those that are sharp; 0: nobody is asked for.
    std::vector<uint32_t> words = {};  ///< Per particle: the bits of its sets. Empty: there are no sets.
};

/// @param shots in order; cameras of the same particles share a set. @throws InputError for more than 32 sets.
FramedSets framedSets(const std::vector<Shot>& shots, const World& world);

/// The shots of a film; where it has none, the one of its camera.
std::vector<Shot> shotsOf(const RenderSettings& settings);

std::vector<Camera> camerasOf(const std::vector<Shot>& shots, const World& world, float aspect);

/// Per plane that is seen and stands still: its unit normal, and its offset along it [m].
std::vector<gpu::vec4> cameraPlanes(const World& world);

/// Colliders with an inside that are seen, and the grids of those that have one.
struct CameraSolids {
    std::vector<gpu::CameraSolid> solids;
    std::vector<float> grids;
};
CameraSolids cameraSolids(const World& world);

}  // namespace knuckle
