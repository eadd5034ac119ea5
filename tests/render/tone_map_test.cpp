#include <cmath>

#include "render/draw_pass.h"
#include "shared/frame_types.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

constexpr GLsizei SIDE = 16;
constexpr int COUNT = SIDE * SIDE;
const char* const CURVES[] = {"", "TONE_NEUTRAL", "TONE_AGX", "TONE_LINEAR"};

/// The pass that blends foam with what is displayed behind it: with much of it, it displays a light; with next to none,
/// it takes what is displayed back to light and displays that again.
struct FoamBlend {
    explicit FoamBlend(const std::string& curve)
    {
        gpu::FrameInput input{};
        input.groundColor.w = 1.0f;
        frame.upload({&input, 1});
        BufferTable table;
        table.add(Lifetime::Scratch, frame, view);
        table.add(lit, foam);
        const Defines defines = curve.empty() ? Defines{} : Defines{{curve, "1"}};
        pass = DrawPass(device, table, {"picture/screen", "fluids/foam_shade", defines},
                        {"frame", "view", "litPicture", "foamPicture"}, target);
    }

    std::vector<Eigen::Vector3f> draw(const std::vector<float>& shown, const std::vector<float>& foams)
    {
        const auto fill = [](const Texture& texture, const std::vector<float>& texels) {
            glBindTexture(GL_TEXTURE_2D, texture.id());
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SIDE, SIDE, GL_RGBA, GL_FLOAT, texels.data());
        };
        fill(lit, shown);
        fill(foam, foams);
        KernelTimer timer;
        pass.drawScreen(timer);
        std::vector<float> out(4 * COUNT);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target.id());
        glReadPixels(0, 0, SIDE, SIDE, GL_RGBA, GL_FLOAT, out.data());
        std::vector<Eigen::Vector3f> colors;
        for (size_t i = 0; i < COUNT; ++i) colors.emplace_back(out[4 * i], out[4 * i + 1], out[4 * i + 2]);
        return colors;
    }

    Gpu& device = sharedGpu();  // before there are buffers
    Buffer<gpu::FrameInput> frame{"frame", 1};
    Buffer<gpu::FrameView> view{"view", 1};
    Texture lit{"litPicture", GL_RGBA32F, SIDE, SIDE}, foam{"foamPicture", GL_RGBA32F, SIDE, SIDE};
    Texture result{"result", GL_RGBA32F, SIDE, SIDE};
    Framebuffer target{"target", {&result}, nullptr};
    DrawPass pass;
};

/// What a curve makes of lights.
std::vector<Eigen::Vector3f> displayed(const std::string& curve, const std::vector<Eigen::Vector3f>& lights)
{
    constexpr float MUCH = 64.0f;  // of what is behind, exp(-64) is left
    std::vector<float> foams;
    for (const Eigen::Vector3f& light : lights)
        foams.insert(foams.end(), {MUCH * light.x(), MUCH * light.y(), MUCH * light.z(), MUCH});
    return FoamBlend(curve).draw(std::vector<float>(4 * COUNT, 0.0f), foams);
}

std::vector<Eigen::Vector3f> greys()
{
    std::vector<Eigen::Vector3f> lights;
    for (int i = 0; i < COUNT; ++i) lights.push_back(Eigen::Vector3f::Constant(0.0002f * std::exp2(0.055f * float(i))));
    return lights;
}

TEST(ToneMap, CurvesRiseFromBlackToWhite)
{
    for (const char* curve : CURVES) {
        const std::vector<Eigen::Vector3f> shown = displayed(curve, greys());
        EXPECT_LT(shown.front().y(), 0.06f) << curve;
        EXPECT_GT(shown.back().y(), 0.75f) << curve;
        for (size_t i = 1; i < COUNT; ++i) ASSERT_GE(shown[i].y(), shown[i - 1].y()) << curve << " at " << i;
        for (const Eigen::Vector3f& color : shown) {
            ASSERT_TRUE((color.array() >= 0.0f && color.array() <= 1.0f).all()) << curve;
            // Grey stays grey; the matrices of AgX have sums of 1 within 1e-3.
            ASSERT_LT(color.maxCoeff() - color.minCoeff(), 2e-3f) << curve;
        }
    }
}

TEST(ToneMap, WhatIsDisplayedGoesBackToItsLight)
{
    // The pass shows foam from 1e-3 on, which takes away as much of what is behind it.
    constexpr float LITTLE = 1.01e-3f;
    std::vector<Eigen::Vector3f> lights;
    for (int i = 0; i < COUNT; ++i)
        lights.push_back(0.004f * std::exp2(0.03f * float(i)) *
                         Eigen::Vector3f(0.4f + 0.6f * float(i % 3), 1.0f, 0.5f + 0.4f * float(i % 5)));
    for (const char* curve : CURVES) {
        const std::vector<Eigen::Vector3f> shown = displayed(curve, lights);
        std::vector<float> behind, foams;
        for (const Eigen::Vector3f& color : shown) {
            behind.insert(behind.end(), {color.x(), color.y(), color.z(), 1.0f});
            foams.insert(foams.end(), {0.0f, 0.0f, 0.0f, LITTLE});
        }
        const std::vector<Eigen::Vector3f> again = FoamBlend(curve).draw(behind, foams);
        // A change of light by LITTLE is one of at most that in display values, whose slope over the logarithm of light
        // is below 1; half of a step of 1/255 beside.
        for (size_t i = 0; i < COUNT; ++i) {
            if (shown[i].maxCoeff() > 0.985f) continue;
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(again[i][k], shown[i][k], 0.003f) << curve << " at " << i;
        }
    }
}

TEST(ToneMap, NeutralKeepsColorsBelowItsHighlights)
{
    // 0.04 is taken away from all three, then comes the display's curve.
    const Eigen::Vector3f light(0.5f, 0.3f, 0.2f);
    const std::vector<Eigen::Vector3f> shown = displayed("TONE_NEUTRAL", std::vector(COUNT, light));
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(shown[0][k], 1.055f * std::pow(light[k] - 0.04f, 1.0f / 2.4f) - 0.055f, 2e-4f);
    const std::vector<Eigen::Vector3f> plain = displayed("TONE_LINEAR", std::vector(COUNT, light));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(plain[0][k], 1.055f * std::pow(light[k], 1.0f / 2.4f) - 0.055f, 2e-4f);
}

TEST(ToneMap, AgxShowsMiddleGreyInTheMiddle)
{
    // By hand: (log2(0.18) + 12.47393) / 16.499999 = 0.60606, of which the polynomial makes 0.4967.
    const std::vector<Eigen::Vector3f> shown = displayed("TONE_AGX",
                                                         std::vector(COUNT, Eigen::Vector3f(0.18f, 0.18f, 0.18f)));
    EXPECT_NEAR(shown[0].y(), 0.4967f, 1.5e-3f);
}

/// All that displays has each curve beside whatever else it includes: the lit picture, fluid, a view from inside it,
/// glass.
TEST(ToneMap, CurvesAreDrawnWithEverything)
{
    StillWorld still(0.04f);
    still.world.fluidSpacing = 0.04f;
    still.world.materials[0].look = {DrawnAs::Surface, 1.0f, 0.0f};
    still.addGround();
    still.addCollider(ColliderShape::Box, {0.6f, 0.1f, 0}).finish.word = Finish::Glass;
    addFluid(still.world, cubeLattice(8, 0.04f));
    for (const ToneMap curve : {ToneMap::Film, ToneMap::Neutral, ToneMap::Agx, ToneMap::Linear})
        for (const float distance : {1.5f, 0.05f}) {
            RenderSettings settings = lookFrom({0, 0.3f * distance, distance}, {0, 0, 0}, 32, 32);
            settings.toneMap = curve;
            const Image image = drawn(still.world, settings);
            EXPECT_GT(pixelAt(image, 16, 16).sum(), 0) << int(curve) << " " << distance;
        }
}

}  // namespace
}  // namespace knuckle::test
