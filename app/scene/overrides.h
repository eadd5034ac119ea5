#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/json/json.h"

namespace knuckle {

/// One `--set path=value`: a dotted path into a scene, or a JSON pointer, and the JSON value to put there.
struct Override {
    std::string path;  ///< "solver.substeps", "objects.0.velocity", "/colliders/2/size"
    Json value;
};

/// Reads "path=value"; a value that is not JSON is taken as a string, that of "fps" as a fraction such as 24000/1001.
/// @param option named in errors. @throws InputError without "=" or a path, and for nan, inf, 1e999 and the like.
Override parseOverride(const std::string& text, const std::string& option = "--set ");
/// Width and height of "640x360". @throws InputError, as of the option --size.
std::array<uint64_t, 2> parsePictureSize(const std::string& text);
/// Sets the value; creates missing objects on the way.
/// @throws InputError for a path through something that is neither object nor array, or past an array's end.
void applyOverride(Json& root, const Override& change);

}  // namespace knuckle
