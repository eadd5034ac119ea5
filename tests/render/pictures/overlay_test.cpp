#include "render/overlay/overlay.h"

#include <cmath>

#include "render/overlay/canvas.h"
#include "render/reader/picture.h"
#include "sim/base/errors.h"
#include "sim/base/utf8.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

const std::string FONT = OverlaySettings().font;
constexpr uint32_t WIDTH = 320, HEIGHT = 200;

Image grey(uint8_t value = 128)
{
    return {WIDTH, HEIGHT, std::vector<uint8_t>(size_t{3} * WIDTH * HEIGHT, value)};
}

RenderSettings withOverlay(const OverlaySettings& overlay)
{
    RenderSettings settings;
    settings.width = WIDTH;
    settings.height = HEIGHT;
    settings.overlay = overlay;
    return settings;
}

Image written(const OverlaySettings& overlay, double time = 0.0)
{
    Image image = grey();
    Overlay(World(), withOverlay(overlay)).draw(image, time, 100.0f);
    return image;
}

/// The box of pixels that differ from plain grey.
Eigen::AlignedBox2i inkOf(const Image& image)
{
    Eigen::AlignedBox2i box;
    for (int y = 0; y < int(image.height); ++y)
        for (int x = 0; x < int(image.width); ++x)
            if (pixelAt(image, uint32_t(x), uint32_t(y)) != Eigen::Vector3i(128, 128, 128))
                box.extend(Eigen::Vector2i(x, y));
    return box;
}

TEST(Overlay, LettersStayInsideTheirLineAndWidth)
{
    Font font(FONT);
    constexpr int SIZE = 40;
    const std::string words = "Ägypten, qj µ";
    Image image = grey();
    Canvas(image, font).text(20, 60, words, SIZE);
    const Eigen::AlignedBox2i box = inkOf(image);
    // Ink may lean by a pixel beyond its advance; the rim is around it.
    const int rim = rimOf(SIZE) + 1;
    EXPECT_GE(box.min().x(), 20 - rim);
    EXPECT_LE(box.max().x(), 20 + int(std::ceil(font.width(words, SIZE))) + rim);
    EXPECT_GE(box.min().y(), 60 - rim);
    EXPECT_LE(box.max().y(), 60 + SIZE + rim);
    EXPECT_GT(box.sizes().x(), int(font.width(words, SIZE)) - 6) << "it is as wide as it says";
}

TEST(Overlay, LettersAreWhiteInsideSmoothAtEdgesAndDarkAround)
{
    Font font(FONT);
    Image image = grey();
    Canvas(image, font).text(20, 40, "H", 100);
    std::array<int, 256> count{};
    for (uint32_t x = 0; x < WIDTH; ++x) ++count[size_t(pixelAt(image, x, 85).x())];
    EXPECT_GT(count[255], 10);
    int between = 0, dark = 0;
    for (int v = 0; v < 60; ++v) dark += count[size_t(v)];
    for (int v = 60; v < 255; ++v) between += v == 128 ? 0 : count[size_t(v)];
    EXPECT_GT(dark, 6);
    EXPECT_GT(between, 0);
}

TEST(Overlay, ReadsUtf8AndReplacesWhatIsNone)
{
    EXPECT_EQ(codePointsOf("aé€😀"), (std::vector<uint32_t>{'a', 0xe9, 0x20ac, 0x1f600}));
    EXPECT_EQ(codePointsOf("\xff"
                           "b\xc3"),
              (std::vector<uint32_t>{0xfffd, 'b', 0xfffd}));
    EXPECT_EQ(codePointsOf("\xe2\x82"
                           "c"),
              (std::vector<uint32_t>{0xfffd, 'c'}));
}

TEST(Overlay, CaptionsAreThereFromTheirFirstFrameToTheirLastAndNowhereElse)
{
    OverlaySettings overlay;
    overlay.captions = {{.text = "now", .from = 0.5f, .to = 0.7f}};
    for (int frame = 1; frame <= 60; ++frame) {
        const double time = (frame - 1) / 60.0;
        // 0.5 s is frame 31, 0.7 s frame 43.
        EXPECT_EQ(inkOf(written(overlay, time)).isEmpty(), frame < 31 || frame >= 43) << frame;
    }
    overlay.captions[0].to = 0.0f;
    EXPECT_FALSE(inkOf(written(overlay, 99.0)).isEmpty()) << "to the end";
}

TEST(Overlay, TextsStandWhereTheySay)
{
    const int w = WIDTH, h = HEIGHT;
    for (const TextPlace at : {TextPlace::Top, TextPlace::TopLeft, TextPlace::TopRight, TextPlace::Center,
                               TextPlace::Bottom, TextPlace::BottomLeft, TextPlace::BottomRight}) {
        OverlaySettings overlay;
        overlay.captions = {{.text = "here", .at = at, .size = 0.1f}};
        const Eigen::Vector2d middle = inkOf(written(overlay)).cast<double>().center();
        const bool left = at == TextPlace::TopLeft || at == TextPlace::BottomLeft;
        const bool right = at == TextPlace::TopRight || at == TextPlace::BottomRight;
        const bool top = at <= TextPlace::TopRight, center = at == TextPlace::Center;
        const int i = static_cast<int>(at);
        EXPECT_TRUE(left    ? middle.x() < 0.3 * w
                    : right ? middle.x() > 0.7 * w
                            : std::abs(middle.x() - 0.5 * w) < 4)
            << i;
        EXPECT_TRUE(top      ? middle.y() < 0.3 * h
                    : center ? std::abs(middle.y() - 0.5 * h) < 6
                             : middle.y() > 0.7 * h)
            << i;
    }
}

TEST(Overlay, LongTextsAreBrokenAndWordsStayWhole)
{
    const Font font(FONT);
    const std::vector<std::string> lines = linesOf("one two three four\nfive", font, 20,
                                                   font.width("one two", 20) + 1.0f);
    EXPECT_EQ(lines, (std::vector<std::string>{"one two", "three", "four", "five"}));
}

TEST(Overlay, AMissingFontIsToldWithItsPackageAndOnlyWhereThereIsText)
{
    OverlaySettings overlay;
    overlay.font = "/nowhere/font.ttf";
    EXPECT_NO_THROW(Overlay(World(), withOverlay(overlay)));
    overlay.title = "x";
    try {
        Overlay(World(), withOverlay(overlay));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("apt install fonts-dejavu-core"), std::string::npos);
    }
}

/// A still camera 4 m away, 45 degrees high: 200 pixels are 2 * 4 m * tan(22.5 degrees). The bar is white, inside of a
/// dark rim; a pixel that it cuts counts in part.
TEST(Overlay, TheScaleBarIsAsLongAsItsMetresAtTheTarget)
{
    StillWorld still(0.05f);
    still.addBody({{0, 5, 0}}, {0, 0, 0});
    RenderSettings settings = lookFrom({0, 0, 4}, {0, 0, 0}, WIDTH, HEIGHT);
    settings.camera.fieldOfView = 45.0f;
    settings.background = Background::Color;
    settings.overlay.scaleBar = true;
    const Image image = drawn(still.world, settings);
    const double pixels = HEIGHT / (2.0 * 4.0 * std::tan(22.5 * M_PI / 180.0));  // a metre: 60.4
    double longest = 0.0;
    for (uint32_t y = HEIGHT / 2; y < HEIGHT; ++y) {
        double length = 0.0;
        for (uint32_t x = 0; x < WIDTH; ++x) length += pixelAt(image, x, y).x() / 255.0;
        longest = std::max(longest, length);
    }
    // A quarter of 320 pixels is 1.3 m: the bar has 1 m. Its dark rim adds a twentieth of a pixel.
    EXPECT_NEAR(longest, pixels, 0.7);
}

TEST(Overlay, LengthsAreRound)
{
    for (const auto& [size, wanted] : {std::pair{1.3f, 1.0f}, {0.49f, 0.2f}, {0.051f, 0.05f}, {99.0f, 50.0f}})
        EXPECT_FLOAT_EQ(roundLength(size), wanted);
}

TEST(Overlay, TheColorBarHasTheEndsOfThePalette)
{
    OverlaySettings overlay;
    overlay.colorBar = true;
    RenderSettings settings = withOverlay(overlay);
    settings.colorBy = ColorBy::Speed;
    settings.palette = Palette::Cividis;
    Image image = grey();
    Overlay(World(), settings).draw(image, 0.0, 1.0f);
    const uint32_t x = WIDTH - uint32_t(0.04f * HEIGHT) - 2;
    for (const auto& [y, share] : {std::pair{0.31f, 0.975f}, {0.5f, 0.5f}, {0.69f, 0.025f}}) {
        const Eigen::Vector3i shown = pixelAt(image, x, uint32_t(y * HEIGHT));
        const Vector3f color = scaleColor(Palette::Cividis, share);
        // A row is 1/80 of the palette, which has steps of up to 40 of 255 in a ninth of it.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], 255.0f * encodeSrgb(color[c]), 6) << y;
    }
}

}  // namespace
}  // namespace knuckle::test
