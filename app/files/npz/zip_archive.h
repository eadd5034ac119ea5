#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace knuckle {

/// Files of an archive: names and contents, in its order.
using ZipEntries = std::vector<std::pair<std::string, std::string>>;

/// Reads a zip archive in memory: stored or deflated, Zip64 as well. @param path named in errors.
/// @throws InputError for what is none, ends early, is damaged, or unpacks to more than 256 MiB.
ZipEntries readZip(std::string_view bytes, const std::string& path);

/// The archive of files that are stored as they are. The same entries give the same bytes.
std::string zipOf(const ZipEntries& entries);

}  // namespace knuckle
