#pragma once

#include <string>
#include <vector>

#include "sim/base/json.h"

namespace knuckle {

/// Objects keep the order in which they were written.
using Json = nlohmann::ordered_json;

/// A document and its name in error messages.
struct JsonFile {
    std::string path;
    Json root;
};

/// Reads JSON with // and /* */ comments.
/// @throws InputError `path:line:column: what` for a syntax error, and for a file that is missing, a folder, larger
/// than 256 MiB, or has a key twice in one object.
JsonFile readJsonFile(const std::string& path);
/// The same for text in memory.
Json parseJson(const std::string& text, const std::string& name);
/// The bytes of a file that is read whole. @param kind what it should be, for errors: "a JSON file".
/// @throws InputError for one that is missing, a folder, or larger than 256 MiB.
std::string readInput(const std::string& path, const char* kind);

/// @throws InputError `path: pointer: message`, the form of every error in a document.
[[noreturn]] void failAt(const std::string& path, const std::string& pointer, const std::string& message);

/// The candidate probably meant by `word`, or empty if none is near.
std::string nearestWord(const std::string& word, const std::vector<std::string>& candidates);
/// `did you mean "x"?`, or `known: a, b, c` if no candidate is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace knuckle
