#pragma once

#include "render/settings.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// The curve that turns light into displayed colours.
Defines curveDefines(const RenderSettings& settings);
/// What shaders are compiled with that write light, or displayed colours: curve and fog.
Defines displayDefines(const RenderSettings& settings);
/// Of shaders that ask for the sky.
Defines skyDefines(const RenderSettings& settings);

/// All of several lists.
Defines joined(std::initializer_list<Defines> lists);

}  // namespace knuckle
