#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// What a name ends in, with its dot and in small letters, as ".mp4"; empty where that is no kind of file: letters and
/// digits, one of them a letter at least, so that "v1.2" has none.
std::string endingOf(const std::string& path);

/// Refuses an output whose name has another ending than these, unless it is a stream.
/// @param option that it was given by, as "--preview ". @param what it holds, as "a picture". @param endings the first
/// of which is advised; an empty one: without an ending as well.
/// @throws InputError with the list of what is known.
void requireEnding(const std::string& option, const std::string& path, const char* what,
                   const std::vector<const char*>& endings);

/// Refuses what is to be a folder and ends as a file does, unless there is one or the name has a slash at its end.
/// @throws InputError.
void requireFolder(const std::string& option, const std::string& path);

}  // namespace knuckle
