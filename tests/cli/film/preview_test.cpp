#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

class FilmPreview : public CliTest {
protected:
    std::string told(const std::string& file) const
    {
        const RunResult result = run({"render", file, "--preview", "-o", "rough"});
        EXPECT_EQ(result.code, 0) << result.err;
        const size_t line = result.out.find("preview of");
        return line == std::string::npos ? result.out : result.out.substr(line, result.out.find(';') - line);
    }
};

TEST_F(FilmPreview, HasAnEighthOfTheParticlesOfWhatIsGivenInMetres)
{
    folder.write("box.json", R"({ "duration": 0.2, "diameter": 0.05, "objects": [
        { "type": "rigid", "shape": "box", "size": [0.4, 0.4, 0.4] }], "render": { "width": 320, "height": 180 } })");
    EXPECT_EQ(told("box.json"), "preview of 64 particles for 512");
    // 12 frames a second of a third of the size.
    EXPECT_EQ(listFolder(folder.path("rough")).size(), 3u);
}

TEST_F(FilmPreview, HasParticlesAsLargeAsTheSceneCanBeMadeOf)
{
    // Of twice as large ones the ball is a single particle, too far from where its rope ends: eight are one and a half
    // times as large, and six of the rope.
    folder.write("rope.json", R"({ "duration": 0.1, "diameter": 0.08, "objects": [
        { "type": "rigid", "shape": "sphere", "name": "ball", "radius": 0.2, "position": [0.16, 0.95, -0.5] },
        { "type": "rope", "from": [0.16, 1.8, -0.5], "to": [0.16, 1.2, -0.5], "end": { "object": "ball" } }],
        "render": { "width": 320, "height": 180 } })");
    EXPECT_EQ(told("rope.json"), "preview of 14 particles for 42");
}

TEST_F(FilmPreview, LeavesAloneWhatIsCountedInParticles)
{
    // Larger ones would overlap with their neighbours, which is no preview of anything, and takes longer.
    folder.write("row.json", R"({ "duration": 0.1, "diameter": 0.1, "objects": [
        { "type": "joined", "size": [3, 3, 3], "repeat": { "counts": [1, 3, 1], "spacing": [1, 0.31, 1] } }],
        "render": { "width": 320, "height": 180 } })");
    const RunResult rough = run({"render", "row.json", "--preview", "-o", "rough", "--export", "bodies=b.csv"});
    ASSERT_EQ(rough.code, 0) << rough.err;
    const RunResult real = run({"render", "row.json", "-o", "real", "--export", "bodies=c.csv", "--quiet"});
    ASSERT_EQ(real.code, 0) << real.err;
    EXPECT_EQ(readText(folder.path("b.csv")), readText(folder.path("c.csv")));
}

}  // namespace
}  // namespace knuckle::test
