#include "app/doctor/vendors.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "app/json/json.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr const char* FILES_VARIABLE = "__EGL_VENDOR_LIBRARY_FILENAMES";
constexpr const char* FOLDERS_VARIABLE = "__EGL_VENDOR_LIBRARY_DIRS";

std::vector<std::string> partsOf(const std::string& list)
{
    std::vector<std::string> parts;
    std::istringstream stream(list);
    for (std::string part; std::getline(stream, part, ':');)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

std::vector<std::string> foldersBelow(const std::string& root)
{
    if (const char* given = std::getenv(FOLDERS_VARIABLE)) return partsOf(given);
    return {root + "/etc/glvnd/egl_vendor.d", root + "/usr/share/glvnd/egl_vendor.d"};
}

std::string libraryIn(const std::string& file)
{
    try {
        return readJsonFile(file).root.at("ICD").at("library_path").get<std::string>();
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace

std::vector<EglVendor> eglVendors(const std::string& root)
{
    std::vector<std::string> files;
    if (const char* given = std::getenv(FILES_VARIABLE)) {
        files = partsOf(given);
    } else {
        for (const std::string& folder : foldersBelow(root)) {
            std::vector<std::string> found;
            std::error_code ignored;
            for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored))
                if (entry->path().extension() == ".json") found.push_back(entry->path().string());
            std::ranges::sort(found);
            files.insert(files.end(), found.begin(), found.end());
        }
    }
    std::vector<EglVendor> vendors;
    for (const std::string& file : files) vendors.push_back({file, libraryIn(file)});
    return vendors;
}

std::string eglVendorPlaces(const std::string& root)
{
    if (const char* given = std::getenv(FILES_VARIABLE)) return std::string(FILES_VARIABLE) + "=" + given;
    std::string places;
    for (const std::string& folder : foldersBelow(root)) places += (places.empty() ? "" : " or ") + folder;
    return places;
}

}  // namespace knuckle
