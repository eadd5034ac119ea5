#pragma once

#include "app/film/film_run.h"

namespace knuckle {

/// Draws and exports frames of a file of states without simulating: with another camera, light, size or skin than the
/// run that wrote it.
/// @param scene with the world of the states. @param options `frames` among those of the file; no recording.
/// @throws InputError also for a scene of another world or frame rate, and for exports that need measures.
void replayFilm(const StatesFile& states, const Scene& scene, const FilmOptions& options, const CommonOptions& common,
                Exporters exporters);

}  // namespace knuckle
