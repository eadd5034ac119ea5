#include "app/sweep/plan.h"

#include <gtest/gtest.h>

#include <set>

#include "app/sweep/runs.h"
#include "app/sweep/sampling.h"
#include "sim/base/errors.h"
#include "tests/message_of.h"

namespace knuckle {
namespace {

using test::messageOf;

SweepPlan planOf(const std::string& text)
{
    return parsePlan({"plan.json", parseJson(text, "plan.json")});
}

/// The fault of a plan, behind its name.
std::string faultOf(const std::string& text)
{
    const std::string message = messageOf<InputError>([&] { planOf(text); });
    return message.starts_with("plan.json: ") ? message.substr(11) : message;
}

/// Of a plan's fields, beside a scene.
std::string faultOfFields(const std::string& fields, const std::string& more = "")
{
    return faultOf(R"({"scene": "a.json", "fields": )" + fields + more + "}");
}

std::string valuesOf(const SweepPlan& plan)
{
    Json all = Json::array();
    for (const SweepRun& run : runsOf(plan)) all.push_back(run.values);
    return all.dump();
}

TEST(SweepPlan, RunsAllCombinationsTheLastFieldFirst)
{
    const SweepPlan plan = planOf(R"({"scene": "a.json", "fields": [
        {"path": "name", "values": ["a", "b"]},
        {"path": "duration", "range": [1, 2], "count": 3},
        {"path": "seed", "range": [4, 5], "count": 2, "whole": true}]})");
    EXPECT_EQ(valuesOf(plan), R"([["a",1.0,4],["a",1.0,5],["a",1.5,4],["a",1.5,5],["a",2.0,4],["a",2.0,5],)"
                              R"(["b",1.0,4],["b",1.0,5],["b",1.5,4],["b",1.5,5],["b",2.0,4],["b",2.0,5]])");
    EXPECT_EQ(runsOf(plan).back().number, 12u);
    EXPECT_EQ(valuesOf(planOf(R"({"scene": "a.json"})")), "[[]]") << "a plan without fields is one run";
}

TEST(SweepPlan, RangesReachTheirEnds)
{
    const SweepPlan plan = planOf(R"({"scene": "a.json", "fields": [
        {"path": "objects.0.velocity", "range": [[0, -0.9], [0.3, -0.3]], "count": 4}]})");
    const std::vector<SweepRun> runs = runsOf(plan);
    EXPECT_EQ(runs.front().values[0].dump(), "[0.0,-0.9]");
    EXPECT_EQ(runs.back().values[0].dump(), "[0.3,-0.3]") << "which -0.9 + (-0.3 - -0.9) is not";
}

TEST(SweepPlan, DrawsTheSameOnEveryMachine)
{
    // Of the 64-bit Mersenne twister that C++ prescribes: a change of these is a change of every sweep that was run.
    const std::string fields = R"("fields": [{"path": "x", "range": [0, 1]}, {"path": "y", "values": [1, 2, 3]},
        {"path": "z", "range": [[-1, 10], [1, 20]]}, {"path": "seed", "range": [1, 6], "whole": true}])";
    const std::string three = valuesOf(planOf(R"({"scene": "a.json", "runs": 3, "seed": 5, )" + fields + "}"));
    EXPECT_EQ(three, "[[0.6730649039714279,1,[-0.5494228861042798,16.759321854327997],1],"
                     "[0.09634242897614698,1,[0.3755583216136793,17.939748045334106],2],"
                     "[0.05196688107189085,2,[-0.44061700614530364,19.245160811643085],2]]");
    const std::string five = valuesOf(planOf(R"({"scene": "a.json", "runs": 5, "seed": 5, )" + fields + "}"));
    EXPECT_TRUE(five.starts_with(three.substr(0, three.size() - 1))) << "more runs begin with the same ones";
    EXPECT_NE(valuesOf(planOf(R"({"scene": "a.json", "runs": 3, "seed": 6, )" + fields + "}")), three);
}

TEST(SweepPlan, DrawsAllOfARangeEvenly)
{
    const SweepPlan plan = planOf(R"({"scene": "a.json", "runs": 6000, "fields": [
        {"path": "x", "range": [2, 4]}, {"path": "seed", "range": [-1, 4], "whole": true}]})");
    double sum = 0.0;
    std::map<int64_t, int> counts;
    for (const std::vector<Json>& values : sampleFields(plan)) {
        const double x = values[0];
        EXPECT_TRUE(2.0 <= x && x <= 4.0) << x;
        sum += x;
        ++counts[values[1].get<int64_t>()];
    }
    // The mean of 6000 has a deviation of 2 / sqrt(12 * 6000) = 0.0075, a count one of sqrt(6000 * 5 / 36) = 29: four.
    EXPECT_NEAR(sum / 6000.0, 3.0, 0.03);
    EXPECT_EQ(counts.size(), 6u);
    for (const auto& [value, count] : counts) EXPECT_NEAR(count, 1000, 116) << value;
}

TEST(SweepPlan, IsNamedByItsFile)
{
    const auto nameOf = [](const std::string& file, const std::string& text) {
        return parsePlan({file, parseJson(text, file)}).name;
    };
    EXPECT_EQ(nameOf("plans/throws.sweep.json", R"({"scene": "a.json"})"), "throws");
    EXPECT_EQ(nameOf("throws.json", R"({"scene": "a.json"})"), "throws");
    EXPECT_EQ(nameOf("throws.json", R"({"scene": "a.json", "name": "b"})"), "b");
    EXPECT_EQ(parsePlan({"plans/p.json", Json{{"scene", "../a.json"}}}).scene, "a.json");
}

TEST(SweepPlan, WithoutEndIsRefused)
{
    EXPECT_EQ(faultOfFields(R"([{"path": "duration", "range": [1, 2]}])"),
              "/fields/0: a range has no end of values: give it a \"count\", or the plan \"runs\", so many at random");
    const std::string many = R"({"path": "x", "range": [1, 2], "count": 1001}, )";
    EXPECT_EQ(faultOfFields("[" + many + R"({"path": "y", "range": [1, 2], "count": 1000}])"),
              "/fields: have more than 1000000 combinations; give \"runs\", so many at random");
    EXPECT_EQ(faultOf(R"({"scene": "a.json", "runs": 1000001})"), "/runs: 1000001 is above the maximum 1000000");
}

TEST(SweepPlan, TellsWhatIsWrongWithAField)
{
    EXPECT_EQ(faultOfFields(R"([{"path": "x"}])"), "/fields/0: must have \"values\" or a \"range\", one of them");
    EXPECT_EQ(faultOfFields(R"([{"path": "x", "values": [1], "range": [1, 2]}])"),
              "/fields/0: must have \"values\" or a \"range\", one of them");
    EXPECT_EQ(faultOfFields(R"([{"path": "x", "range": [2, 1], "count": 2}])"),
              "/fields/0/range: begins at 2 and ends at 1; exchange them");
    EXPECT_EQ(faultOfFields(R"([{"path": "x", "range": [[1, 2], [1]], "count": 2}])"),
              "/fields/0/range: has two ends of different length; give both as many numbers");
    EXPECT_EQ(faultOfFields(R"([{"path": "x", "range": [1, 2.5], "count": 2, "whole": true}])"),
              "/fields/0/range: 2.5 is no whole number; the field is `whole`");
    EXPECT_EQ(faultOfFields(R"([{"path": "x", "values": [1], "count": 2}])"),
              "/fields/0/count: is of a \"range\"; leave it out");
    EXPECT_EQ(faultOfFields(R"([{"path": "x", "values": [1]}, {"path": "x", "values": [1]}])"),
              "/fields/1/path: x is given twice; remove one");
    EXPECT_EQ(faultOfFields("[]", R"(, "runs": 5)"), "/runs: all 5 would be the same; give \"fields\" that differ");
}

TEST(SweepPlan, TellsWhatIsWrongWithItself)
{
    EXPECT_EQ(faultOf("{}"), "/: \"scene\" is missing; name a scene file, or \"states\" that were recorded");
    EXPECT_EQ(faultOf(R"({"scen": "a.json"})"), "/scen: unknown field; did you mean \"scene\"?");
    const auto with = [](const std::string& more) { return faultOf(R"({"scene": "a.json", )" + more + "}"); };
    EXPECT_EQ(with(R"("output": "../film.mp4")"),
              "/output: \"../film.mp4\" must be a name without folders: it is in that of each run");
    EXPECT_TRUE(with(R"("output": "film.avi")").starts_with("/output: -o film.avi: films are written as "));
    EXPECT_TRUE(with(R"("output": "film")").starts_with("/output: \"film\" is none: a film ends in "));
    EXPECT_EQ(with(R"("exports": {"bvh": "log"})"), "/exports/bvh: \"log\" is another file of each run; rename it");
    EXPECT_EQ(with(R"("parts": 2, "output": "film.mp4")"),
              "/parts: needs \"states\": only what is recorded is drawn in parts");
    EXPECT_EQ(with(R"("frames": ["1:2"])"), "/frames/0: still.png is no single picture; name frames as frame_####.png");
    EXPECT_EQ(with(R"("frames": ["b"])"),
              "/frames/0: --frames b: must be A:B, frames from 1, for instance 1:60, or last");
    EXPECT_EQ(faultOf(R"({"states": "a.states", "parts": 2})"),
              "/output: still.png is a single picture, and parts have more; name frames as frame_####.png");
}

}  // namespace
}  // namespace knuckle
