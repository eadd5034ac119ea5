#pragma once

#include <string>
#include <utility>

#include "app/export/exporter.h"
#include "render/output/frame_names.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Writes a file for each frame into a folder: frame_0001 and so on.
class FolderExport : public Exporter {
public:
    /// @param ending of the files, with its dot.
    FolderExport(std::string path, std::string ending) : Exporter(std::move(path)), ending_(std::move(ending)) {}
    void addPaths(const Scene& /*scene*/, RunPaths& paths) const override { paths.writesFrames(names()); }
    void begin(const Scene& /*scene*/) override { requireWritableFolder(path()); }
    void finish() override {}

protected:
    FrameNames names() const { return {.folder = path(), .after = ending_}; }

private:
    std::string ending_;
};

}  // namespace knuckle
