#pragma once

#include <string>
#include <vector>

#include "app/export/rig.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// The simulated motion as one clip of a binary glTF file: actors with their own skeletons, meshes and materials, other
/// bodies as nodes with their particles. What does not consist of bodies is left out.
class GltfExport {
public:
    /// @throws InputError for a scene without bodies, and for a file that cannot be written.
    GltfExport(const std::string& path, const Scene& scene);
    /// Of the next frame.
    void add(const World& world, const std::vector<BodyState>& states);
    /// @param framesPerSecond of what was added. @throws RunError from a full disk.
    void finish(double framesPerSecond);

    /// What of a world has no place in the file: "colliders", "fluids", ...
    static std::vector<std::string> leftOut(const World& world);

private:
    std::vector<Rig> rigs_;
    OutputFile file_;
};

}  // namespace knuckle
