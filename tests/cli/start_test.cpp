// What a program starts with: kernels that are compiled when they are needed, and the driver's cache of them.
#include <filesystem>
#include <fstream>
#include <future>

#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

class Start : public test::CliTest {
protected:
    Start() { fs::create_directory(cache()); }

    std::string cache() const { return folder.path("cache"); }
    /// Four frames, and the hash of the last.
    RunResult film(const std::string& output, const std::string& frames = "1:4",
                   const std::string& cacheFolder = {}) const
    {
        const std::string where = cacheFolder.empty() ? cache() : cacheFolder;
        return run({"--quiet", "render", scene, "--frames", frames, "--hash", "-o", folder.path(output)},
                   {.environment = {"MESA_SHADER_CACHE_DIR=" + where, "XDG_CACHE_HOME=" + where}});
    }
    std::vector<fs::path> cached() const
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(cache()))
            // Mesa's index of all is as large from the start.
            if (entry.is_regular_file() && entry.path().filename() != "index") files.push_back(entry.path());
        std::ranges::sort(files);
        return files;
    }
    uintmax_t cachedBytes() const
    {
        uintmax_t sum = 0;
        for (const fs::path& file : cached()) sum += fs::file_size(file);
        return sum;
    }
};

/// Another byte in the middle.
void flip(const fs::path& path)
{
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    const auto middle = static_cast<std::streamoff>(fs::file_size(path) / 2);
    file.seekg(middle);
    const char byte = static_cast<char>(~file.get());
    file.seekp(middle);
    file.put(byte);
}

TEST_F(Start, APictureOfTheStartCompilesNoStep)
{
    ASSERT_EQ(film("one", "1").code, 0);
    const uintmax_t start = cachedBytes();
    ASSERT_EQ(film("two", "1:2").code, 0);
    // A step has more kernels than a picture. Nothing is there where the driver keeps none.
    EXPECT_TRUE(start == 0 || cachedBytes() > 2 * start) << start << " and " << cachedBytes();
}

TEST_F(Start, ADamagedCacheChangesNothing)
{
    const RunResult first = film("first");
    ASSERT_EQ(first.code, 0) << first.err;
    std::vector<fs::path> files = cached();
    for (size_t i = 0; i < files.size(); ++i) {
        if (i % 2 == 0) flip(files[i]);
        else fs::resize_file(files[i], fs::file_size(files[i]) / 2);
    }
    const RunResult again = film("again");
    EXPECT_EQ(again.code, 0);
    EXPECT_EQ(again.err, "");
    EXPECT_EQ(again.out, first.out);
    EXPECT_EQ(test::readText(folder.path("again/frame_0004.png")), test::readText(folder.path("first/frame_0004.png")));
}

TEST_F(Start, RunsAtOnceShareACache)
{
    std::vector<std::future<RunResult>> runs;
    for (const char* output : {"a", "b", "c"})
        runs.push_back(std::async(std::launch::async, [=, this] { return film(output); }));
    std::vector<RunResult> results;
    for (auto& one : runs) results.push_back(one.get());
    for (const RunResult& result : results) {
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.out, results[0].out);
    }
    EXPECT_NE(results[0].out.find("state hash "), std::string::npos);
}

TEST_F(Start, NeedsNoFolderForTheCache)
{
    const RunResult none = film("none", "1:4", "/dev/null/none");
    EXPECT_EQ(none.code, 0);  // Mesa tells it by itself
    EXPECT_EQ(none.out, film("some").out);
}

}  // namespace
}  // namespace knuckle
