#pragma once

#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/scene/scene_file.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// What the bits of a run depend on. Two runs with the same have the same states and pictures; the number of threads
/// does not count.
struct RunFingerprint {
    std::string program;  ///< "knuckle 0.1.0".
    std::string build;    ///< Of the program's file: a build from other source has another.
    std::string shaders;
    std::string driver;  ///< GL_VERSION.
    std::string device;  ///< GL_RENDERER.
    std::string world;   ///< fingerprint(World).
    std::string scene;   ///< Scene::documentHash.
    std::string files;   ///< Contents of all files that the scene reads.

    Json json() const;
    /// @throws InputError that names `file` if a field is missing.
    static RunFingerprint read(const Json& json, const std::string& file);
};

/// "knuckle 0.1.0".
std::string programVersion();
/// @throws InputError for a file of the scene that cannot be read any more.
RunFingerprint fingerprintOf(const Scene& scene, const Gpu& gpu);
/// One phrase for each difference: `the driver is "4.5 Mesa 25.0", not "4.5 Mesa 22.3.6"`. Empty: none.
std::vector<std::string> differences(const RunFingerprint& here, const RunFingerprint& there);
/// The same for states alone, whatever is drawn of them.
std::vector<std::string> stateDifferences(const RunFingerprint& here, const RunFingerprint& there);

}  // namespace knuckle
