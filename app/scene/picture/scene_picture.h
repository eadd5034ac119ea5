#pragma once

#include "app/json/json.h"
#include "app/scene/picture/scene_cameras.h"
#include "app/scene/scene_files.h"
#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// How the scene is drawn: `render`, `light`, `lights`, `camera`, `cameras` and `shots`. @throws InputError.
RenderSettings readPicture(const JsonFile& file, const World& world, const NamedParticles& particles,
                           SceneFiles& files);

}  // namespace knuckle
