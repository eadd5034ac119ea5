#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/json/json.h"
#include "app/scene/overrides.h"

namespace knuckle {

/// A field of the scene that differs from run to run.
struct SweepField {
    std::string path;
    std::vector<Json> values;  ///< Empty: any of the range.
    Json low, high;            ///< Ends of the range, numbers or vectors of one length; null if the field has none.
    bool whole = false;        ///< Values of the range are whole numbers.
};

/// A plan's document. assets/schema/sweep.schema.json has every field.
struct SweepPlan {
    std::string path;                    ///< Of its file.
    std::string name;                    ///< Of the sweep.
    std::string document;                ///< As text, with all defaults.
    std::string scene, states;           ///< Paths; empty: none.
    std::vector<Override> changes;       ///< Of all runs.
    std::vector<SweepField> fields;      ///< That differ.
    std::optional<uint64_t> randomRuns;  ///< So many that draw their values; none: all combinations.
    uint32_t seed = 1;
    std::vector<std::string> frames;                           ///< As of --frames; empty: all.
    uint64_t parts = 1;                                        ///< Of each range of frames.
    bool shots = false;                                        ///< Each is a run.
    std::string output;                                        ///< Name of what each run draws.
    std::vector<std::pair<std::string, std::string>> exports;  ///< Kind and name.
    std::vector<std::string> bodies, measures;
    double checkpointSeconds = 30.0;

    bool simulates() const { return states.empty(); }
    /// Whether each run draws one picture, whose name has no number.
    bool isStill() const;
};

/// The most runs that a sweep may have.
inline constexpr uint64_t MAX_RUNS = 1000000;

/// Reads and checks a plan by itself, without its scene. @throws InputError of one line with the JSON path.
SweepPlan readPlan(const std::string& path);
/// The same for a document in memory. @param path of its file, from whose folder other files are named.
SweepPlan parsePlan(JsonFile file);

}  // namespace knuckle
