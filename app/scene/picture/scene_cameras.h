#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// Particles of objects and of their copies, by name.
using NamedParticles = std::map<std::string, std::vector<ParticleRange>>;

/// Name of the camera of every scene that goes once around all that moves, in the time of the whole film.
constexpr const char* TURNTABLE = "turntable";

/// Fills in the cameras of a scene: `camera`, `cameras`, `shots` and `render.camera`. @throws InputError.
void readCameras(const JsonFile& file, const World& world, const NamedParticles& particles, RenderSettings& render);

}  // namespace knuckle
