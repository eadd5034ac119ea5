#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/checkpoint/checkpoint.h"
#include "app/export/exporters.h"
#include "app/film/branch_run.h"
#include "app/film/frame_range.h"
#include "app/film/recording.h"
#include "app/film/run_figures.h"
#include "app/run/open_gpu.h"
#include "app/scene/scene_file.h"
#include "render/output/frame_sink.h"

namespace knuckle {

/// Options of `knuckle render` apart from the scene.
struct FilmOptions {
    std::vector<std::string> outputs;  ///< Folders or names for frames, and films.
    std::vector<std::string> cameras;  ///< Of the outputs, by name; empty, or too few: the scene's own shots.
    std::string codec, pipe;           ///< As of FilmFormat.
    FrameRange frames;
    int quality = DEFAULT_QUALITY;  ///< Of JPEG.
    uint32_t depth = 8;             ///< Of PNG, bits of a channel.
    bool skipExisting = false;      ///< Pictures that are there and whole stay.
    std::string stats;              ///< Empty: none.
    RecordOptions record;
    CheckpointOptions checkpoint;
    SceneSource source;  ///< Where the scene came from, for recordings.
    bool hash = false;
    const Branch* branch = nullptr;  ///< Where the scene goes on from; null: it begins at time 0.
    std::optional<bool> drawAside;   ///< On a separate thread; none: if that is faster.
};

/// Simulates the scene and writes its frames and all other requested outputs. Checks every output first.
/// @throws InputError, DeviceError, RunError, Interrupted.
/// @returns what was measured; nothing where all frames were there.
RunFigures runFilm(const Scene& scene, const FilmOptions& options, const CommonOptions& common,
                   Exporters exporters = {});

}  // namespace knuckle
