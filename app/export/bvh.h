#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/export/exporter.h"
#include "app/export/rig.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Motions of actors as BVH files, one an actor: the rest pose as OFFSETs in centimetres, rotations in the order Z, X,
/// Y in degrees, the position of the root. A joint that leaves its place in its parent has a position as well.
class BvhExport : public Exporter {
public:
    /// @param path of the file of a single actor; for several, names of their objects are put before its ending.
    using Exporter::Exporter;
    ExportNeeds needs() const override { return {.bodies = true}; }
    void addPaths(const Scene& scene, RunPaths& paths) const override;
    /// @throws InputError also for a scene without actors.
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
    void finish() override;

private:
    double framesPerSecond_ = 0.0;
    std::vector<Rig> rigs_;
    std::vector<std::unique_ptr<OutputFile>> files_;
    std::vector<std::vector<std::vector<Eigen::Isometry3f>>> motions_;  ///< Per rig and frame, of each bone.
};

/// The files of `--export bvh=path`, one an actor. @throws InputError for several of them into one stream.
std::vector<std::string> bvhPaths(const std::string& path, const Scene& scene);

/// The text of a BVH file. @param frames each bone's motion from the rest pose, in each frame.
std::string bvhText(const Rig& rig, const std::vector<std::vector<Eigen::Isometry3f>>& frames, double framesPerSecond);

}  // namespace knuckle
