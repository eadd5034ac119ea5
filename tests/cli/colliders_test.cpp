#include "tests/cli/cli_fixture.h"

namespace knuckle {
namespace {

/// Colliders as users write them.
using Colliders = test::CliTest;

/// The height of the last body in the last line of a table.
double lastHeight(const std::string& table)
{
    std::string line = table.substr(table.find_last_of('\n', table.size() - 2) + 1);
    for (int field = 0; field < 5; ++field) line = line.substr(line.find(',') + 1);
    return std::stod(line);
}

TEST_F(Colliders, LetFallWhatIsBesideARaisedContainer)
{
    folder.write("raised.json", R"({ "duration": 1, "colliders": [ { "type": "plane" },
        { "type": "container", "width": 0.8, "depth": 0.8, "height": 0.5, "position": [0, 1, 0] } ],
        "objects": [ { "type": "rigid", "shape": "box", "position": [3, 2, 0] } ] })");
    const test::RunResult result = run(
        {"render", "raised.json", "--export", "bodies=b.csv", "-o", "frames", "--frames", "60:60", "--size", "64x36"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NEAR(lastHeight(test::readText(folder.path("b.csv"))), 0.15, 0.002);
}

TEST_F(Colliders, TellOfAnOpenMeshWhatItCountsAs)
{
    folder.write("trough.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 4\nf 1 4 3\nf 1 3 2\n");
    folder.write("open.json", R"({ "colliders": [ { "type": "mesh", "file": "trough.obj", "scale": 1 } ],
        "objects": [ { "type": "rigid", "shape": "box", "position": [3, 2, 0] } ] })");
    test::RunResult result = run({"check", "open.json"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE((result.out + result.err)
                  .find("/colliders/0: the mesh is open, 1.73 m wide, and counts as solid behind "
                        "that; close it, or give it a `thickness` to be a thin wall"),
              std::string::npos)
        << result.out << result.err;
    result = run({"check", "open.json", "--set", "colliders.0.thickness=0.05"});
    EXPECT_EQ((result.out + result.err).find("the mesh is open"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace knuckle
