#pragma once

#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

/// A folder with a tiny scene in it: one falling pair, four frames of 64 x 36 pixels.
class CliTest : public testing::Test {
protected:
    CliTest() : scene(folder.write("tiny.json", TINY_SCENE)) {}

    static constexpr const char* TINY_SCENE = R"({
        "duration": 0.0667, "colliders": [{ "type": "plane" }],
        "objects": [{ "type": "joined", "name": "pair", "position": [0, 0.3, 0] }],
        "render": { "width": 64, "height": 36 } })";

    /// Runs in the test's folder on the software driver, with the same result everywhere.
    RunResult run(std::vector<std::string> arguments, RunOptions options = {}) const
    {
        if (options.folder.empty()) options.folder = folder.path();
        arguments.insert(arguments.begin(), {"--device", "software"});
        return runKnuckle(arguments, options);
    }
    /// Expects one line on stderr, nothing on stdout and the exit code.
    void expectError(const RunResult& result, int code, const std::string& message) const
    {
        EXPECT_EQ(result.code, code) << result.err;
        EXPECT_EQ(result.err, "knuckle: " + message + "\n");
        EXPECT_EQ(result.out, "");
    }
    /// The files in the folder other than the scene.
    std::vector<std::string> madeFiles() const
    {
        std::vector<std::string> files = listFolder(folder.path());
        std::erase(files, "tiny.json");
        return files;
    }

    TempFolder folder;
    std::string scene;
};

}  // namespace knuckle::test
