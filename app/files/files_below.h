#pragma once

#include <set>
#include <string>

namespace knuckle {

/// Paths of all files below a folder, relative to it, with "/" between their parts. Links to folders are followed, but
/// for those that lead to a folder around them. @throws InputError if a folder cannot be read.
std::set<std::string> filesBelow(const std::string& folder);

}  // namespace knuckle
