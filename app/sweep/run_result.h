#pragma once

#include <optional>
#include <string>

#include "app/sweep/sweep.h"

namespace knuckle {

/// What is known of a run that is done: OUT/run_0001/done.json.
struct RunResult {
    std::string hash;     ///< Of the last state; of recorded states of what was drawn.
    std::string picture;  ///< Name of the film, or of the last picture.
    std::string device;   ///< Empty where nothing was simulated.
    std::string host;
    Json measures = Json::object();  ///< By name, of the last frame.
    Json bodies = Json::object();    ///< By name, mass centres after the last frame [m].
    double seconds = 0.0;
};

/// Reads what a run has written, and marks it as done, durably. @throws InputError for what is missing or damaged;
/// RunError (full disk).
void finishRun(const Sweep& sweep, const SweepRun& run, const std::string& host, double seconds);

/// None: it is not done.
std::optional<RunResult> readResult(const RunFolder& folder);

}  // namespace knuckle
