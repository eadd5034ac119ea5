#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/api/world.h"

namespace knuckle {

/// The parts of a scene file that a Simulation needs; docs/scene.md has every field of the file.
struct SceneWorld {
    std::string name, description;
    World world;
    double framesPerSecond = 60.0;
    double duration = 0.0;           ///< [s]
    uint32_t stepsPerFrame = 1;      ///< Settings::timeStep is 1 / (framesPerSecond * stepsPerFrame).
    std::vector<std::string> notes;  ///< Deviations from the file, one sentence each.
};

/// Reads, checks and builds a scene; models are imported and filled with particles.
/// @param changes such as "solver.substeps=8", in the form of `knuckle render --set`.
/// @throws InputError, one line with the file and the JSON pointer of the fault.
SceneWorld loadSceneWorld(const std::string& path, const std::vector<std::string>& changes = {});

}  // namespace knuckle
