#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// The ending of a name, with its dot and in lower case, such as ".mp4"; empty if it is not that of a kind of file,
/// which has letters and digits, at least one of them a letter: "v1.2" has none.
std::string endingOf(const std::string& path);

/// Refuses an output with any other ending, unless it is a stream.
/// @param option with which it was given, such as "--preview ". @param what it holds, such as "a picture". @param
/// endings the first is advised; an empty one allows no ending.
/// @throws InputError with the list of known endings.
void requireEnding(const std::string& option, const std::string& path, const char* what,
                   const std::vector<const char*>& endings);

/// Refuses a folder's name that ends like a file's, unless the folder exists or the name ends with a slash.
/// @param what is written there. @throws InputError.
void requireFolder(const std::string& option, const std::string& path, const char* what = "frames");

}  // namespace knuckle
