#pragma once

#include <algorithm>
#include <filesystem>

#include "tests/cli/cli_fixture.h"

namespace knuckle::test {

/// `knuckle sweep` as typed.
class SweepCommand : public CliTest {
protected:
    /// Heights of the tiny scene's pair.
    static constexpr const char* FIELDS =
        R"("fields": [{"path": "objects.0.position.1", "values": [0.3, 0.4, 0.5, 0.6]}])";

    void writePlan(const std::string& more = FIELDS) const
    {
        folder.write("plan.json", R"({"scene": "tiny.json", "bodies": ["pair/body_1"], )" + more + "}");
    }
    RunResult sweep(std::vector<std::string> words, RunOptions options = {}) const
    {
        words.insert(words.begin(), {"-q", "sweep"});
        return run(words, std::move(options));
    }
    std::string table(const std::string& out) const
    {
        const RunResult result = sweep({"collect", "plan.json", "-o", out});
        EXPECT_EQ(result.code, 0) << result.err;
        return readText(folder.path(out + "/table.csv"));
    }
    /// With a program in place of Slurm's.
    RunOptions withSbatch(const std::string& script) const
    {
        std::filesystem::create_directory(folder.path("bin"));
        folder.write("bin/sbatch", "#!/bin/sh\n" + script);
        std::filesystem::permissions(folder.path("bin/sbatch"), std::filesystem::perms::owner_all);
        return {.environment = {"PATH=" + folder.path("bin") + ":/usr/bin:/bin"}};
    }
    /// The number of files of that beginning in the folders of runs.
    int countFiles(const std::string& out, const std::string& beginning) const
    {
        const std::vector<std::string> files = listFolder(folder.path(out));
        return static_cast<int>(std::ranges::count_if(files, [&](const std::string& file) {
            return std::filesystem::path(file).filename().string().starts_with(beginning);
        }));
    }
};

}  // namespace knuckle::test
