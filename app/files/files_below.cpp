#include "app/files/files_below.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/base/errors.h"

namespace knuckle {

namespace fs = std::filesystem;

namespace {

/// Whether a link leads to a folder that it stands in, so that following it would never end.
bool leadsBack(const fs::directory_entry& entry)
{
    std::error_code error;
    if (!entry.is_symlink(error)) return false;
    const fs::path target = fs::canonical(entry.path(), error),
                   folder = fs::canonical(entry.path().parent_path(), error);
    if (error) return true;
    return std::ranges::mismatch(target, folder).in1 == target.end();
}

}  // namespace

std::set<std::string> filesBelow(const std::string& folder)
{
    std::set<std::string> files;
    std::error_code error, ignored;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::follow_directory_symlink, error);
    for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
        if (leadsBack(*entry)) entry.disable_recursion_pending();
        if (!entry->is_directory(ignored)) files.insert(entry->path().lexically_relative(folder).generic_string());
    }
    if (error) throw InputError(fmt::format("folder {} cannot be read: {}", folder, error.message()));
    return files;
}

}  // namespace knuckle
