#pragma once

#include "render/settings.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// What shaders are compiled with that turn light into displayed colours.
Defines displayDefines(const RenderSettings& settings);
/// Of shaders that ask for the sky.
Defines skyDefines(const RenderSettings& settings);

/// All of several lists.
Defines joined(std::initializer_list<Defines> lists);

}  // namespace knuckle
