#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

using Tracing = test::CliTest;

/// Where the loader finds a library, or empty.
std::string libraryPath(const char* name, const char* functionInIt)
{
    void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    void* function = library != nullptr ? dlsym(library, functionInIt) : nullptr;
    Dl_info info{};
    return function != nullptr && dladdr(function, &info) != 0 ? info.dli_fname : "";
}

// apitrace's EGL tracer replaces libGL, and has no GLX; glvnd's libOpenGL is also such a libGL.
TEST_F(Tracing, WorksWhereLibGlHasNoGlx)
{
    const std::string libOpenGl = libraryPath("libOpenGL.so.0", "glEnable");
    if (libOpenGl.empty()) GTEST_SKIP() << "libopengl0 is not installed";
    std::filesystem::create_directory(folder.path("lib"));
    std::filesystem::create_symlink(libOpenGl, folder.path("lib/libGL.so.1"));
    const test::RunResult result = run({"render", scene, "-o", "out", "--quiet"},
                                       {.environment = {"LD_LIBRARY_PATH=" + folder.path("lib")}});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(test::listFolder(folder.path("out")).size(), 4u);
}

TEST_F(Tracing, WorksUnderApitrace)
{
    if (std::system("command -v apitrace >/dev/null") != 0) GTEST_SKIP() << "apitrace is not installed";
    const std::string trace = folder.path("render.trace");
    const std::string command = "apitrace trace --api=egl -o '" + trace + "' '" + test::programPath() +
                                "' --device software " + "render '" + scene + "' --quiet -o '" + folder.path("out") +
                                "' >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_GT(std::filesystem::file_size(trace), 0u);
}

}  // namespace
}  // namespace knuckle
