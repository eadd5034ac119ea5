#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/json/json.h"
#include "render/compare/verdict.h"

namespace knuckle {

/// Limits that were given, on the command line or in a file; those that were not are empty.
struct GivenLimits {
    std::optional<double> threshold, share, mean, largest, tile, flip, ssim;
    std::optional<uint64_t> pixels;

    /// Puts them in place of others. A number of pixels without a share beside it lifts the limit of the share.
    void applyTo(float& threshold, CompareLimits& limits) const;
};

/// A file of limits, see assets/schema/limits.schema.json.
struct LimitsFile {
    GivenLimits general;
    std::map<std::string, GivenLimits> names;  ///< By pattern.

    /// What the file says of an image. @param name its path below the compared folder, or its file's name.
    void applyTo(const std::string& name, float& threshold, CompareLimits& limits) const;
};

/// @param json of the form of the schema, with `default` and `names`.
LimitsFile limitsOf(const Json& json);
/// @throws InputError of one line with the JSON path.
LimitsFile readLimits(const std::string& path);

}  // namespace knuckle
