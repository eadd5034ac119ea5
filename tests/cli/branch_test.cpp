#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

/// A run of 30 frames, whose states are recorded, and scenes that go on from one of them.
class Branches : public CliTest {
protected:
    static constexpr const char* PAIR = R"({ "type": "joined", "name": "pair", "position": [0, 0.3, 0] })";
    static constexpr const char* SAND =
        R"({ "type": "grains", "name": "sand", "shape": "box", "size": [0.3, 0.3, 0.3], "position": [1, 0.4, 0] })";
    static constexpr const char* BALL = R"({ "type": "rigid", "shape": "sphere", "name": "ball", "radius": 0.15,
        "position": [0, 1.5, 0], "velocity": [0, -2, 0] })";

    /// Writes a scene. @param start "" for one from time 0.
    void write(const std::string& name, const std::string& objects, const std::string& start = {},
               const std::string& more = {})
    {
        folder.write(name, fmt::format(R"({{ "duration": 0.5, {} {} "colliders": [{{ "type": "plane" }}],
            "objects": [{}], "render": {{ "width": 64, "height": 36 }} }})",
                                       start.empty() ? "" : "\"start\": " + start + ",", more, objects));
    }
    std::string both() const { return std::string(PAIR) + ", " + SAND; }
    RunResult render(std::vector<std::string> words)
    {
        words.insert(words.begin(), "render");
        return run(words);
    }
    /// The run, with its bodies in run.csv.
    void record(const std::string& more = {})
    {
        write("run.json", both(), {}, more);
        const RunResult result = render({"run.json", "-o", "run", "--record", "states=run.states", "--record-every",
                                         "10", "--export", "bodies=run.csv", "--export", "ply=run_ply", "-q"});
        ASSERT_EQ(result.code, 0) << result.err;
    }
    /// Lines of an export of bodies, of a frame or from it on.
    std::vector<std::string> lines(const std::string& file, int from, int to = 1000) const
    {
        std::istringstream text(readText(folder.path(file)));
        std::vector<std::string> out;
        for (std::string line; std::getline(text, line);)
            if (const int frame = std::atoi(line.c_str()); frame >= from && frame <= to) out.push_back(line);
        return out;
    }
    void expectSamePictures(const std::string& one, const std::string& other, int from, int to)
    {
        EXPECT_EQ(listFolder(folder.path(one)).size(), static_cast<size_t>(to - from + 1));
        for (int frame = from; frame <= to; ++frame) {
            const std::string name = fmt::format("/frame_{:04}.png", frame);
            const RunResult compared = run({"compare", one + name, other + name, "--max-difference", "0"});
            EXPECT_EQ(compared.code, 0) << compared.out << compared.err;
        }
    }
};

TEST_F(Branches, OfTheSameSceneHaveItsBits)
{
    const std::string camera = R"("camera": { "kind": "follow", "follow": "pair" },)";
    record(camera);
    for (const int frame : {11, 17, 30}) {
        write("same.json", both(), fmt::format(R"({{ "from": "run.states", "frame": {} }})", frame), camera);
        const RunResult result = render({"same.json", "-o", "same", "--export", "bodies=same.csv", "--hash"});
        ASSERT_EQ(result.code, 0) << result.err;
        EXPECT_NE(
            result.err.find(fmt::format("knuckle: note: goes on from run.states, frame {}: all as it was\n", frame)),
            std::string::npos)
            << result.err;
        EXPECT_EQ(lines("same.csv", 1), lines("run.csv", frame));
        expectSamePictures("same", "run", frame, 30);
        const RunResult whole = render({"run.json", "-o", "whole", "--hash", "-q"});
        EXPECT_NE(result.out.find(whole.out), std::string::npos) << result.out << whole.out;
        std::filesystem::remove_all(folder.path("same"));
    }
}

TEST_F(Branches, ShowWhatBothHaveAsItWasAndWhatIsNewWhereTheSceneSays)
{
    record();
    write("ball.json", std::string(BALL) + ", " + both(), R"({ "from": "run.states", "frame": 17 })");
    const RunResult result = render(
        {"ball.json", "-o", "ball", "--export", "bodies=ball.csv", "--export", "ply=ball_ply"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(
        result.err.find("knuckle: note: goes on from run.states, frame 17: 2 bodies and 27 loose particles as they "
                        "were; new: ball\n"),
        std::string::npos)
        << result.err;
    const auto withoutNumbers = [](std::vector<std::string> rows) {
        for (std::string& row : rows) row.erase(0, row.find(',', row.find(',') + 1));
        return rows;
    };
    std::vector<std::string> rows = withoutNumbers(lines("ball.csv", 17, 17));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].find(",ball,body,0,1.5,0,0,0,0,1,0,-2,0,"), 0u) << rows[0];
    rows.erase(rows.begin());
    EXPECT_EQ(rows, withoutNumbers(lines("run.csv", 17, 17)));
    EXPECT_EQ(listFolder(folder.path("ball_ply")).front(), "frame_0017.ply");
}

TEST_F(Branches, GoOnWithoutWhatIsGone)
{
    record();
    write("sand.json", SAND, R"({ "from": "run.states" })", R"("name": "sand only",)");
    const RunResult checked = run({"check", "sand.json", "--set", "duration=1"});
    EXPECT_EQ(checked.code, 0) << checked.err;
    EXPECT_TRUE(checked.out.starts_with(
        "sand.json: note: goes on from run.states, frame 30: 27 loose particles as they were; gone: pair\n"))
        << checked.out;
    const RunResult result = render({"sand.json", "-o", "sand", "--set", "duration=1", "-q"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(listFolder(folder.path("sand")).size(), 31u);
}

/// As any run: from checkpoints, from states, and to be gone on from in turn.
TEST_F(Branches, AreRunsThemselves)
{
    record();
    write("ball.json", both() + ", " + BALL, R"({ "from": "run.states", "frame": 17 })");
    const auto branch = [&](const std::string& out, std::vector<std::string> more) {
        std::vector<std::string> words{
            "ball.json", "-o", out, "--export", "bodies=" + out + ".csv", "--record", "states=" + out + ".states",
            "-q"};
        words.insert(words.end(), more.begin(), more.end());
        const RunResult result = render(words);
        EXPECT_EQ(result.code, 0) << result.err;
    };
    branch("whole", {});
    branch("part", {"--checkpoint", "0", "--set", "duration=0.4"});
    branch("part", {"--checkpoint", "0", "--resume"});
    EXPECT_EQ(readText(folder.path("part.csv")), readText(folder.path("whole.csv")));
    expectSamePictures("part", "whole", 17, 30);

    EXPECT_EQ(render({"--from", "whole.states", "-o", "again", "--export", "bodies=again.csv", "-q"}).code, 0);
    EXPECT_EQ(readText(folder.path("again.csv")), readText(folder.path("whole.csv")));
    expectSamePictures("again", "whole", 17, 30);

    // Its first frame is a whole state. The file that it went on from need not be there any more.
    std::filesystem::remove(folder.path("run.states"));
    write("third.json", both() + ", " + BALL, R"({ "from": "whole.states", "frame": 20 })");
    EXPECT_EQ(render({"third.json", "-o", "third", "--export", "bodies=third.csv", "-q"}).code, 0);
    EXPECT_EQ(lines("third.csv", 1), lines("whole.csv", 20));
}

TEST_F(Branches, KnowTheSceneOfTheRunThoughItsFileHasChanged)
{
    record();
    write("run.json", both() + ", " + BALL, R"({ "from": "run.states", "frame": 12 })");
    const RunResult result = run({"check", "run.json"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("; new: ball\n"), std::string::npos) << result.out;
}

/// As many particles do not make the same thing.
TEST_F(Branches, TakeAnotherShapeOfOneNameForNew)
{
    const auto things = [](const char* soft, const char* cloth, const char* rope) {
        return fmt::format(R"({{ "type": "soft", "shape": "box", "name": "soft", "size": {}, "position": [0, 2, 0] }},
            {{ "type": "cloth", "name": "cloth", "size": {}, "position": [3, 2, 0] }},
            {{ "type": "{}", "name": "third", {} }})",
                           soft, cloth, std::string(rope) == "rope" ? "rope" : "grains",
                           std::string(rope) == "rope"
                               ? R"("from": [6, 1, 0], "to": [6.8, 1, 0])"
                               : R"("shape": "box", "size": [0.9, 0.1, 0.1], "position": [6, 1, 0])");
    };
    write("run.json", things("[0.9, 0.3, 0.3]", "[1, 0.5]", "rope"));
    ASSERT_EQ(render({"run.json", "-o", "run", "--save-state", "run.states", "-q", "--frames", "1:2"}).code, 0);
    const auto expect = [&](const std::string& objects, const std::string& end) {
        write("other.json", objects + ", " + BALL, R"({ "from": "run.states" })");
        const RunResult result = run({"check", "other.json"});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_NE(result.out.find(end + "\n"), std::string::npos) << result.out;
    };
    expect(things("[0.9, 0.3, 0.3]", "[1, 0.5]", "rope"), "as they were; new: ball");
    expect(things("[0.3, 0.9, 0.3]", "[1, 0.5]", "rope"), "new: soft, ball; gone: soft");
    expect(things("[0.9, 0.3, 0.3]", "[0.5, 1]", "rope"), "new: ball, cloth; gone: cloth");
    expect(things("[0.9, 0.3, 0.3]", "[1, 0.5]", "grains"), "new: ball, third; gone: third");
}

/// Two scenes that differ in names alone have the same world.
TEST_F(Branches, TakeARenamedThingForNew)
{
    record();
    std::string renamed = PAIR;
    renamed.replace(renamed.find("pair"), 4, "twin");
    write("other.json", renamed + ", " + SAND, R"({ "from": "run.states", "frame": 17 })");
    const RunResult result = run({"check", "other.json"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("frame 17: 27 loose particles as they were; new: twin; gone: pair\n"), std::string::npos)
        << result.out;
}

/// A pool with a drain at its floor, and branches of it: the same, with its fluid elsewhere, and without the drain.
TEST_F(Branches, TellWhatBecomesOfFluids)
{
    const auto pool = [](const char* x) {
        return fmt::format(R"({{ "type": "fluid", "name": "water", "shape": "box", "size": [0.3, 0.2, 0.2],
            "position": [{}, 0.3, 0] }})",
                           x);
    };
    const std::string drain = R"("drains": [{ "shape": "box", "size": [4, 0.2, 4], "position": [0, 0.1, 0] }],)";
    const std::string start = R"({ "from": "pool.states", "frame": 10 })";
    write("pool.json", pool("0"), {}, drain);
    ASSERT_EQ(render({"pool.json", "-o", "pool", "--record", "states=pool.states", "--record-every", "5", "-q"}).code,
              0);
    write("moved.json", pool("0.5"), start, drain);
    const RunResult moved = run({"check", "moved.json"});
    EXPECT_EQ(moved.code, 0) << moved.err;
    std::smatch told;
    const std::regex wanted(R"(frame 10: nothing is as it was; (\d+) particles of fluid new at their start; (\d+) )"
                            R"(particles of fluid gone\n)");
    ASSERT_TRUE(std::regex_search(moved.out, told, wanted)) << moved.out;
    EXPECT_LT(std::stoi(told[2]), std::stoi(told[1])) << "what has drained away is not lost by the branch";
    write("undrained.json", pool("0"), start);
    for (const char* command : {"check", "render"})
        expectError(run({command, "undrained.json"}), 2,
                    "undrained.json: /start/frame: some of the fluid has drained away by frame 10, and the scene has "
                    "no drain; keep one, out of the way if nothing is to drain any more");
    write("kept.json", pool("0"), start,
          R"("drains": [{ "shape": "box", "size": [1, 1, 1], "position": [9, 9, 9] }],)");
    const RunResult kept = render({"kept.json", "-o", "kept", "-q"});
    EXPECT_EQ(kept.code, 0) << kept.err;
}

TEST_F(Branches, AreRefusedInOneLine)
{
    record();
    const auto refused = [&](const std::string& start, std::vector<std::string> words, const std::string& message) {
        write("other.json", both() + ", " + BALL, start);
        for (const char* command : {"check", "render"}) {
            std::vector<std::string> all{command, "other.json"};
            all.insert(all.end(), words.begin(), words.end());
            expectError(run(all), 2, message);
        }
    };
    const std::string good = R"({ "from": "run.states", "frame": 17 })";
    refused(R"({})", {},
            "other.json: /start: \"from\" is missing; add it: A file of states, as `knuckle render --record "
            "states=FILE.states` writes it, relative to the scene file.");
    refused(R"({ "from": "no.states" })", {},
            "other.json: /start/from: there is no file no.states; paths are relative to the scene");
    refused(R"({ "from": "run.json" })", {},
            "run.json: is not a file of states, as --record and --save-state write them");
    refused(R"({ "from": "run.states", "frame": 31 })", {},
            "other.json: /start/frame: run.states has frames 1 to 30; choose among them");
    refused(R"({ "from": "run.states", "frame": 1.5 })", {},
            "other.json: /start/frame: is 1.5 (a number), must be an integer");
    refused(good, {"--set", "duration=0.2"},
            "other.json: /duration: 0.2 s end with frame 12, before frame 17, with which the scene begins; raise it");
    refused(good, {"--set", "fps=30"},
            "other.json: /start/from: run.states has 60 frames a second, the scene 30; set /fps to 60");
    refused(good, {"--set", "diameter=0.09"},
            "other.json: /start/from: run.states has particles of 0.1 m, the scene of 0.09 m; set /diameter to 0.1");
    refused(
        good, {"--set", "solver=paper"},
        "other.json: /start/from: run.states is of another world than the scene, and the paper's solver cannot take "
        "one over into another; use the solver \"default\" in both");
    write("other.json", both(), good);
    expectError(render({"other.json", "--frames", "3:20"}), 2,
                "--frames 3:20: the scene has frames 17 to 30; choose among them or raise /duration");
    expectError(render({"other.json", "-o", "x", "--record", "states=run.states"}), 2,
                "run.states would be written over run.states, which is read; give the output another name");
    EXPECT_EQ(render({"run.json", "-o", "end", "--save-state", "end.states", "-q"}).code, 0);
    write("other.json", both(), R"({ "from": "end.states", "frame": 17 })");
    expectError(run({"check", "other.json"}), 2,
                "other.json: /start/frame: end.states has frames 30; choose among them");
}

}  // namespace
}  // namespace knuckle::test
