#pragma once

#include "app/json/json.h"
#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// How the scene is drawn: `render`, `camera` and `light`. @throws InputError.
RenderSettings readPicture(const JsonFile& file, const World& world);

}  // namespace knuckle
