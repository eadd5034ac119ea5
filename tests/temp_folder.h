#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace knuckle::test {

/// A separate folder for one test, removed with everything in it.
class TempFolder {
public:
    TempFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "knuckle_test_XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TempFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string path() const { return path_.string(); }
    std::string path(const std::string& file) const { return (path_ / file).string(); }
    /// Writes a file. @returns its path.
    std::string write(const std::string& file, const std::string& text) const
    {
        std::ofstream(path(file), std::ios::binary) << text;
        return path(file);
    }

private:
    std::filesystem::path path_;
};

inline std::string readText(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace knuckle::test
