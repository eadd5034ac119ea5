#include "app/files/assets.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace knuckle {

namespace {

namespace fs = std::filesystem;

/// From Python's module, PREFIX/lib/python3.N/dist-packages/knuckle/_knuckle.so, up to PREFIX; in a folder for
/// building, build/release/python/knuckle, up to the source.
constexpr int MOST_STEPS = 5;

/// The file with this code: the program, or Python's module.
fs::path thisFile()
{
    static const int within = 0;
    Dl_info info{};
    if (dladdr(&within, &info) != 0 && info.dli_fname != nullptr && fs::path(info.dli_fname).is_absolute())
        return info.dli_fname;
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored);
}

}  // namespace

std::string findAsset(const std::string& path)
{
    std::error_code ignored;
    if (!path.starts_with("assets/") || fs::exists(path, ignored)) return path;
    fs::path above = thisFile();
    for (int step = 0; step < MOST_STEPS && above.has_relative_path(); ++step) {
        above = above.parent_path();
        for (const fs::path& found : {above / "share" / "knuckle" / path, above / path})
            if (fs::exists(found, ignored)) return found.string();
    }
    return path;
}

}  // namespace knuckle
