#include "render/panes/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr uint32_t SMALLEST = 16, INSET_PART = 3;             // [pixels]; of the width and the height
constexpr float MARGIN = 0.04f, LINE = 0.004f;                // in heights of the picture
constexpr std::array WORDS{"", "left/", "right/", "inset/"};  // of PanePlace

bool isSecond(PanePlace place)
{
    return place == PanePlace::Right || place == PanePlace::Inset;
}

/// Settings of a pane: the whole picture's, but for its size and cameras.
RenderSettings settingsOf(const RenderSettings& whole, PanePlace place)
{
    RenderSettings settings = whole;
    settings.overlay = {};
    const uint32_t left = (whole.width + 1) / 2;
    if (place == PanePlace::Left) settings.width = left;
    if (place == PanePlace::Right) settings.width = whole.width - left;
    if (place == PanePlace::Inset) {
        settings.width = whole.width / INSET_PART;
        settings.height = whole.height / INSET_PART;
    }
    if (settings.width < SMALLEST || settings.height < SMALLEST)
        throw InputError(
            fmt::format("shots: a part of {} x {} pixels is too small; take a larger picture, or leave out "
                        "`inset` and `beside`",
                        settings.width, settings.height));
    if (isSecond(place)) settings.legend = false;
    for (Shot& shot : settings.shots) {
        if (isSecond(place)) shot.camera = shot.other;
        shot.layout = PictureLayout::One;
    }
    return settings;
}

/// Columns and rows, without their ends.
struct Part {
    uint32_t left = 0, top = 0, right = 0, bottom = 0;
};

void fillWhite(Image& image, const Part& part)
{
    for (uint32_t y = part.top; y < std::min(part.bottom, image.height); ++y) {
        const size_t first = size_t(y) * image.width + part.left, count = part.right - part.left;
        std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * first), 3 * count, uint8_t{255});
        if (!image.deep.empty())
            std::fill_n(image.deep.begin() + static_cast<std::ptrdiff_t>(3 * first), 3 * count, uint16_t{65535});
        if (!image.alpha.empty())
            std::fill_n(image.alpha.begin() + static_cast<std::ptrdiff_t>(first), count, uint8_t{255});
    }
}

template <typename T>
void copyRow(const std::vector<T>& from, size_t first, std::vector<T>& to, size_t at, size_t count)
{
    if (!from.empty())
        std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), count,
                    to.begin() + static_cast<std::ptrdiff_t>(at));
}

/// @param left, top of the part in the image.
void copyInto(Image& image, const Image& part, uint32_t left, uint32_t top)
{
    for (uint32_t y = 0; y < part.height; ++y) {
        const size_t from = size_t(y) * part.width, to = size_t(top + y) * image.width + left;
        copyRow(part.rgb, 3 * from, image.rgb, 3 * to, 3 * size_t(part.width));
        copyRow(part.deep, 3 * from, image.deep, 3 * to, 3 * size_t(part.width));
        copyRow(part.alpha, from, image.alpha, to, part.width);
    }
}

uint32_t pixelsOf(float share, uint32_t height)
{
    return std::max(1u, static_cast<uint32_t>(std::lround(share * static_cast<float>(height))));
}

}  // namespace

bool isShown(PanePlace place, const Shot& shot)
{
    const bool beside = shot.layout == PictureLayout::Beside;
    if (place == PanePlace::Inset) return shot.layout == PictureLayout::Inset;
    return beside == (place != PanePlace::Whole);
}

std::string wordOf(PanePlace place)
{
    return WORDS[static_cast<size_t>(place)];
}

std::vector<PanePlan> planPanes(const RenderSettings& settings)
{
    checkSettings(settings);
    std::vector<PanePlan> plans;
    const std::vector<Shot> shots = settings.shots.empty() ? std::vector<Shot>(1) : settings.shots;
    for (const PanePlace place : {PanePlace::Whole, PanePlace::Left, PanePlace::Right, PanePlace::Inset})
        if (std::ranges::any_of(shots, [&](const Shot& shot) { return isShown(place, shot); }))
            plans.push_back({place, settingsOf(settings, place)});
    return plans;
}

Image besideEachOther(const Image& left, const Image& right)
{
    Image image{.width = left.width + right.width, .height = left.height};
    const size_t pixels = size_t(image.width) * image.height;
    image.rgb.resize(3 * pixels);
    if (!left.deep.empty()) image.deep.resize(3 * pixels);
    if (!left.alpha.empty()) image.alpha.resize(pixels);
    copyInto(image, left, 0, 0);
    copyInto(image, right, left.width, 0);
    const uint32_t line = pixelsOf(LINE, image.height), begin = left.width - (line + 1) / 2;
    fillWhite(image, {begin, 0, begin + line, image.height});
    return image;
}

void placeInset(Image& image, const Image& inset, Corner corner)
{
    const uint32_t margin = pixelsOf(MARGIN, image.height), line = pixelsOf(LINE, image.height);
    const bool right = corner == Corner::TopRight || corner == Corner::BottomRight;
    const bool bottom = corner == Corner::BottomLeft || corner == Corner::BottomRight;
    const uint32_t left = right ? image.width - margin - inset.width : margin;
    const uint32_t top = bottom ? image.height - margin - inset.height : margin;
    fillWhite(image, {left - line, top - line, left + inset.width + line, top + inset.height + line});
    copyInto(image, inset, left, top);
}

}  // namespace knuckle
