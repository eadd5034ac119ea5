#pragma once

#include "tests/cli/cli_fixture.h"

namespace knuckle::test {

/// A golden of the tiny scene, in golden/tiny: frames 1 and 4.
class GoldenTest : public CliTest {
protected:
    void add(const std::vector<std::string>& more = {})
    {
        std::vector<std::string> words{"golden", "add", "tiny.json", "--frames", "first,4", "--size", "96x54", "-q"};
        words.insert(words.end(), more.begin(), more.end());
        const RunResult result = run(words);
        ASSERT_EQ(result.code, 0) << result.err;
    }
    RunResult check(std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(), {"golden", "check"});
        return run(more);
    }
    /// Replaces words in a file of the test's folder.
    void edit(const std::string& file, const std::string& before, const std::string& after) const
    {
        std::string text = readText(folder.path(file));
        const size_t at = text.find(before);
        ASSERT_NE(at, std::string::npos) << file << " has no " << before;
        folder.write(file, text.replace(at, before.size(), after));
    }
    void pretendOtherDriver() const { edit("golden/tiny/golden.json", "\"driver\": \"", "\"driver\": \"other "); }
    static bool has(const RunResult& result, const std::string& words)
    {
        return result.out.find(words) != std::string::npos;
    }

    static constexpr const char* STATES = "golden/tiny/states@llvmpipe.states";
};

}  // namespace knuckle::test
