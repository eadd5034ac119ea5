#include "app/files/assets.h"

#include <filesystem>
#include <system_error>

namespace knuckle {

std::string findAsset(const std::string& path)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (!path.starts_with("assets/") || fs::exists(path, ignored)) return path;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share" / "knuckle" / path;
    return !program.empty() && fs::exists(installed, ignored) ? installed.string() : path;
}

}  // namespace knuckle
