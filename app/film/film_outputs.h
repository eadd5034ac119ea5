#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/export/exporters.h"
#include "app/files/run_paths.h"
#include "app/film/film_run.h"
#include "app/film/frame_drawing.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Whether `-o path` is a film, else a folder for frames: true for a stream, and for a name with a film's ending. A
/// slash at the end makes any name a folder's.
/// @throws InputError for another ending, and for a film's name at which there is a folder.
bool isFilm(const std::string& path);

/// Adds all outputs of a run. @throws InputError as RunPaths does.
void addOutputs(const FilmOptions& options, const Exporters& exporters, const Scene& scene, RunPaths& paths);

/// All outputs, opened before the first step so that nothing is simulated in vain.
struct FilmOutputs {
    FrameSinks sinks;
    Exporters exporters;
    ExportNeeds needs;  ///< Of all exporters.
    std::optional<OutputFile> stats;

    /// @param range of the frames to draw. @param checkpoint keeps what is drawn; null: nothing is kept.
    /// @throws InputError for outputs that cannot be written.
    FilmOutputs(const Scene& scene, const FilmOptions& options, const FrameRange& range, Exporters chosen,
                Checkpoint* checkpoint = nullptr);

    /// Whether a frame is needed for any picture.
    bool wantsPicture(uint64_t frame) const;
    /// Whether its pictures have labels.
    bool hasLabels() const { return hasFolders_; }

private:
    std::unique_ptr<FrameSink> makeSink(const Scene& scene, const FilmOptions& options, size_t output,
                                        const FrameRange& range, Checkpoint* checkpoint);

    bool hasFolders_ = false;
};

}  // namespace knuckle
