#include <filesystem>

#include "app/json/json.h"
#include "tests/cli/cli_fixture.h"
#include "tests/places.h"

namespace knuckle {
namespace {

namespace fs = std::filesystem;
using test::RunResult;

class ComparePrograms : public test::CliTest {
protected:
    /// A script in place of a program.
    std::string script(const std::string& name, const std::string& does) const
    {
        const std::string path = folder.write(name, "#!/bin/sh\n" + does + "\n");
        fs::permissions(path, fs::perms::owner_all);
        return path;
    }
    /// One that prints a benchmark's JSON.
    std::string prints(const std::string& name, const std::string& key, double value) const
    {
        return script(name, "echo '{ \"runs\": [{ \"" + key + "\": " + std::to_string(value) + " }] }'");
    }
};

TEST_F(ComparePrograms, TellsWhichIsFaster)
{
    const std::string slow = prints("slow", "stepsPerSecond", 100), fast = prints("fast", "stepsPerSecond", 125);
    const RunResult faster = run({"bench", "compare", slow, fast, "--bench", "table2", "--rounds", "6"});
    EXPECT_EQ(faster.code, 0) << faster.err;
    EXPECT_NE(faster.out.find("table2       10.00      8.00   B is 25.0 % faster (97 %: 25.0 .. 25.0)\n"),
              std::string::npos)
        << faster.out;
    const RunResult slower = run({"bench", "compare", fast, slow, "--bench", "table2", "--rounds", "6"});
    EXPECT_NE(slower.out.find("B is 20.0 % slower"), std::string::npos) << slower.out;
    const RunResult same = run({"bench", "compare", slow, slow, "--bench", "table2", "--rounds", "6"});
    EXPECT_NE(same.out.find("no difference seen"), std::string::npos) << same.out;
}

TEST_F(ComparePrograms, RunsThemInTurn)
{
    const std::string says = "; echo '{ \"runs\": [{ \"milliseconds\": 5 }] }'";
    const std::string log = folder.path("log");
    const std::string a = script("a", "printf a >>" + log + says), b = script("b", "printf b >>" + log + says);
    const RunResult result = run({"bench", "compare", a, b, "--bench", "dam", "--rounds", "6"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(test::readText(log), "baabbaabbaabba");
}

TEST_F(ComparePrograms, WritesEachTimeAsJson)
{
    const std::string one = prints("one", "skinsMilliseconds", 3), two = prints("two", "skinsMilliseconds", 2);
    const RunResult result = run({"bench", "compare", one, two, "--bench", "draw", "--rounds", "7", "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json figures = parseJson(result.out, "figures");
    EXPECT_EQ(figures["benchmark"], "compare");
    EXPECT_EQ(figures["a"], one);
    EXPECT_EQ(figures["b"], two);
    EXPECT_EQ(figures["rounds"], 7);
    const Json& first = figures["runs"][0];
    EXPECT_EQ(first["bench"], "draw");
    EXPECT_EQ(first["aMilliseconds"], Json(std::vector<double>(7, 3.0)));
    EXPECT_EQ(first["bMilliseconds"], Json(std::vector<double>(7, 2.0)));
    EXPECT_DOUBLE_EQ(first["medianRatio"].get<double>(), 1.5);
    EXPECT_EQ(first["difference"], "faster");
    const std::string page = test::readText(test::inSource("docs/output.md"));
    for (const auto& [key, value] : first.items()) EXPECT_NE(page.find('`' + key + '`'), std::string::npos) << key;
}

TEST_F(ComparePrograms, TimesAStartByTheClock)
{
    const std::string log = folder.path("log");
    const std::string program = script("program", "echo $* >>" + log + "; ls $MESA_SHADER_CACHE_DIR >>" + log +
                                                      "; touch $MESA_SHADER_CACHE_DIR/shader");
    ASSERT_EQ(run({"bench", "compare", program, program, "--bench", "cold", "--rounds", "6"}).code, 0);
    const std::string cold = test::readText(log);
    EXPECT_NE(cold.find("--quiet --device software render /"), std::string::npos) << cold;
    EXPECT_EQ(cold.find("shader\n"), std::string::npos) << cold;
    fs::remove(log);
    ASSERT_EQ(run({"bench", "compare", program, program, "--bench", "warm", "--rounds", "6"}).code, 0);
    EXPECT_NE(test::readText(log).find("shader\n"), std::string::npos);
}

TEST_F(ComparePrograms, RefusesWhatIsNoProgram)
{
    const std::string good = script("good", "exit 0");
    const std::string advice = "; give the paths of two knuckle programs";
    expectError(run({"bench", "compare", "nowhere", good}), 2,
                "bench compare: nowhere cannot be run: No such file or directory" + advice);
    const std::string plain = folder.write("plain", "text");
    expectError(run({"bench", "compare", good, plain}), 2,
                "bench compare: " + plain + " cannot be run: Permission denied" + advice);
    expectError(run({"bench", "compare", good, folder.path()}), 2,
                "bench compare: " + folder.path() + " cannot be run: No such file or directory" + advice);
    EXPECT_EQ(run({"bench", "compare", good}).code, 2);
    EXPECT_EQ(run({"bench", "compare", good, good, "--bench", "nothing"}).code, 2);
    EXPECT_EQ(run({"bench", "compare", good, good, "--rounds", "5"}).code, 2);
}

TEST_F(ComparePrograms, TellsWhichProgramFails)
{
    const std::string good = prints("good", "milliseconds", 5);
    const std::string bad = script("bad", "echo knuckle: no room >&2; exit 3"), odd = script("odd", "echo hello");
    expectError(run({"bench", "compare", good, bad, "--bench", "sand", "--json"}), 1,
                bad + ": sand failed with exit code 3: knuckle: no room");
    expectError(run({"bench", "compare", odd, good, "--bench", "sand", "--json"}), 1,
                odd + ": bench sand prints no figures that are known here; leave it out by --bench");
}

}  // namespace
}  // namespace knuckle
