#include <algorithm>
#include <cmath>
#include <sstream>

#include <Eigen/Geometry>

#include "render/picture/image.h"
#include "sim/base/angles.h"
#include "tests/cli/cli_fixture.h"

namespace knuckle::test {
namespace {

using Eigen::Quaternionf;
using Eigen::Vector3f;

constexpr uint32_t SIDE = 200;
constexpr float DISTANCE = 6.0f;

/// A box of 8 x 4 x 4 particles of 0.1 m turns in front of the sky, drawn as its shape.
const char* const TURNING = R"({ "duration": 0.4, "fps": 10, "diameter": 0.1, "solver": { "gravity": [0, 0, 0] },
    "camera": { "position": [0, 0, 6], "target": [0, 0, 0], "fieldOfView": 30 },
    "materials": { "default": { "color": [0.9, 0.02, 0.02], "draw": "shape" } },
    "objects": [{ "type": "rigid", "shape": "box", "size": [0.8, 0.4, 0.4], "rotation": [20, 30, 10],
                  "velocity": [0.5, 0.3, -1], "spin": [1, 2, 3] }],
    "render": { "width": 200, "height": 200, "colorBy": "material" } })";

using Shapes = CliTest;

struct Sides {
    float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;  ///< [pixels]
};

/// Of the image of the hull of spheres of a particle's radius at the box's corners.
Sides expectedSides(const Vector3f& position, const Quaternionf& rotation)
{
    const float radius = 0.05f, scale = 0.5f * SIDE / std::tan(15.0f * DEGREE);
    Sides sides;
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3f half(corner & 1 ? 0.35f : -0.35f, corner & 2 ? 0.15f : -0.15f, corner & 4 ? 0.15f : -0.15f);
        const Vector3f c = position + rotation * half;
        const float d = DISTANCE - c.z();
        // Slopes s of tangents through the eye: (a - s d)^2 = r^2 (1 + s^2).
        const auto slope = [&](float a, float side) {
            return (a * d + side * radius * std::sqrt(a * a + d * d - radius * radius)) / (d * d - radius * radius);
        };
        sides.left = std::min(sides.left, 0.5f * SIDE + scale * slope(c.x(), -1));
        sides.right = std::max(sides.right, 0.5f * SIDE + scale * slope(c.x(), 1));
        sides.top = std::min(sides.top, 0.5f * SIDE - scale * slope(c.y(), 1));
        sides.bottom = std::max(sides.bottom, 0.5f * SIDE - scale * slope(c.y(), -1));
    }
    return sides;
}

/// Of all pixels that are red.
Sides shownSides(const Image& image)
{
    Sides sides;
    for (uint32_t i = 0; i < SIDE * SIDE; ++i) {
        const uint8_t* pixel = &image.rgb[size_t{3} * i];
        if (pixel[0] - pixel[2] <= 35) continue;
        const float x = static_cast<float>(i % SIDE), y = static_cast<float>(i / SIDE);
        sides.left = std::min(sides.left, x);
        sides.right = std::max(sides.right, x + 1.0f);
        sides.top = std::min(sides.top, y);
        sides.bottom = std::max(sides.bottom, y + 1.0f);
    }
    return sides;
}

TEST_F(Shapes, ABoxIsDrawnWhereTheExportSaysThatTheBodyIs)
{
    folder.write("turning.json", TURNING);
    const RunResult result = run({"render", "turning.json", "-o", "run", "--export", "bodies=run.csv", "--quiet"});
    ASSERT_EQ(result.code, 0) << result.err;
    std::istringstream rows(readText(folder.path("run.csv")));
    std::string row, word;
    std::getline(rows, row);
    int frames = 0;
    while (std::getline(rows, row)) {
        std::istringstream words(row);
        std::vector<std::string> cells;
        while (std::getline(words, word, ',')) cells.push_back(word);
        ASSERT_GE(cells.size(), 11u) << row;
        const auto number = [&](size_t cell) { return std::stof(cells[cell]); };
        const Vector3f position(number(4), number(5), number(6));
        const Quaternionf rotation(number(10), number(7), number(8), number(9));
        const Sides expected = expectedSides(position, rotation);
        const Sides seen = shownSides(readImage(folder.path("run/frame_000" + cells[0] + ".png")));
        // A pixel is red or not, and the edge filter mixes one more.
        EXPECT_NEAR(seen.left, expected.left, 1.0f) << row;
        EXPECT_NEAR(seen.right, expected.right, 1.0f) << row;
        EXPECT_NEAR(seen.top, expected.top, 1.0f) << row;
        EXPECT_NEAR(seen.bottom, expected.bottom, 1.0f) << row;
        ++frames;
    }
    EXPECT_EQ(frames, 4);
}

TEST_F(Shapes, AreDrawnFromStatesAndOnASecondThreadAsInTheRun)
{
    folder.write("turning.json", TURNING);
    const std::vector<std::string> render{"render", "turning.json", "--quiet", "-o"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), render.begin(), render.end());
        return more;
    };
    ASSERT_EQ(run(with({"run", "--record", "states=run.states"})).code, 0);
    // One core draws where it simulates.
    ASSERT_EQ(run(with({"here", "--stats", "stats.json"})).code, 0);
    ASSERT_EQ(run({"render", "--from", "run.states", "-o", "again", "--quiet"}).code, 0);
    for (const char* other : {"again", "here"})
        for (int frame = 1; frame <= 4; ++frame) {
            const std::string name = "/frame_000" + std::to_string(frame) + ".png";
            EXPECT_EQ(readImage(folder.path("run" + name)).rgb, readImage(folder.path(other + name)).rgb) << other;
        }
}

TEST_F(Shapes, OfAWordThatIsNoneTheErrorIsOneLine)
{
    folder.write("turning.json", TURNING);
    expectError(run({"render", "turning.json", "--set", "objects.0.draw=box"}), 2,
                "turning.json: /objects/0/draw: \"box\" is unknown; known: auto, particles, surface, shape");
    expectError(run({"render", "turning.json", "--set", "materials.default.draw=surface"}), 2,
                "turning.json: /objects/0/material: \"default\" says \"draw\": \"surface\", and a rigid box has none; "
                "give it \"draw\": \"shape\" or \"particles\", or another material");
}

}  // namespace
}  // namespace knuckle::test
