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

/// Whether `-o path` is a film, else frames (FrameNames): true for a stream, and for a name with a film's ending. A
/// slash at the end makes any name a folder's.
/// @throws InputError for another ending, and for a film's name at which there is a folder.
bool isFilm(const std::string& path);

/// Looks at all that can be said of `-o`, --codec and --pipe before the scene is read. @throws InputError for names and
/// words that are none, and for words that no output asks for.
void checkOutputs(const FilmOptions& film);

/// Adds all outputs of a run. @throws InputError as RunPaths does.
void addOutputs(const FilmOptions& options, const Exporters& exporters, const Scene& scene, RunPaths& paths);

/// Says what of the world exporters leave out.
void tellLeftOut(const Exporters& exporters, const World& world);

/// The last frame that any output lacks; 0: all are there. The range's last if something else than pictures is wanted
/// of the run, or existing ones are not skipped.
uint64_t lastMissing(const Scene& scene, const FilmOptions& options, const FrameRange& range);

/// All outputs, opened before the first step so that nothing is simulated in vain.
struct FilmOutputs {
    std::vector<std::unique_ptr<PictureKeep>> existing;  ///< Of --skip-existing; sinks ask them.
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
    bool hasLabels() const { return hasLabels_; }

private:
    std::unique_ptr<FrameSink> makeSink(const Scene& scene, const FilmOptions& options, size_t output,
                                        const FrameRange& range, Checkpoint* checkpoint);

    bool hasLabels_ = false;
};

}  // namespace knuckle
