#pragma once

#include <string>

#include "app/files/npz/zip_archive.h"
#include "app/json/json.h"

namespace knuckle {

/// The document of an actor as arrays of NumPy, docs/actor-format.md: a field is an array `NAME`, that of all bodies
/// or joints `bodies_NAME`, `joints_NAME`; lists of lists have a second one, NAME_starts, of where each begins and the
/// last ends.
/// @param document completed by its schema.
ZipEntries arraysOf(const Json& document);

/// The inverse. What an array has is not checked beyond its type and shape; what is not there is left out.
/// @param path named in errors. @throws InputError for an array that is unknown, of another shape or type, or with
/// numbers that are not finite.
Json documentOf(const ZipEntries& arrays, const std::string& path);

}  // namespace knuckle
