#pragma once

#include <vector>

#include "app/json/json.h"
#include "app/scene/scene_files.h"
#include "render/settings.h"

namespace knuckle {

/// `light`: the key light, and the sky as far as it needs no picture. @throws InputError.
LightSettings readLight(const JsonFile& file, SceneFiles& files);

/// `lights`. @throws InputError.
std::vector<LightSource> readLights(const JsonFile& file);

}  // namespace knuckle
