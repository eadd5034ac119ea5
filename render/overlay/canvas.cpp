#include "render/overlay/canvas.h"

#include <algorithm>
#include <cmath>

#include "sim/base/utf8.h"

namespace knuckle {

namespace {

const Eigen::Vector3f WHITE{1, 1, 1}, DARK{0.05f, 0.05f, 0.06f};
constexpr float RIM_OPACITY = 0.8f;

/// Ink of a whole line, 0 to 1.
struct Mask {
    int width = 0, height = 0;
    std::vector<float> values;

    Mask(int w, int h) : width(w), height(h), values(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
    float& at(int x, int y) { return values[static_cast<size_t>(y) * static_cast<size_t>(width) + size_t(x)]; }
    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

void stamp(Mask& mask, const Glyph& glyph, int left, int top)
{
    for (int y = 0; y < glyph.height; ++y)
        for (int x = 0; x < glyph.width; ++x) {
            if (!mask.has(left + x, top + y)) continue;
            const float ink = static_cast<float>(glyph.ink[size_t(y) * size_t(glyph.width) + size_t(x)]) / 255.0f;
            float& value = mask.at(left + x, top + y);
            value = std::max(value, ink);
        }
}

/// The largest ink within `radius`.
Mask widened(Mask& mask, int radius)
{
    Mask wide(mask.width, mask.height);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            for (int dy = -radius; dy <= radius; ++dy)
                for (int dx = -radius; dx <= radius; ++dx)
                    if (dx * dx + dy * dy <= radius * radius && mask.has(x + dx, y + dy))
                        wide.at(x, y) = std::max(wide.at(x, y), mask.at(x + dx, y + dy));
    return wide;
}

template <typename Channel>
void mixChannels(Channel* rgb, const Eigen::Vector3f& color, float share, float most)
{
    for (int c = 0; c < 3; ++c) {
        const float before = static_cast<float>(rgb[c]), after = before + share * (most * color[c] - before);
        rgb[c] = static_cast<Channel>(std::lround(std::clamp(after, 0.0f, most)));
    }
}

}  // namespace

int rimOf(int size)
{
    return std::max(1, size / 16);
}

void Canvas::mix(int x, int y, const Eigen::Vector3f& color, float share)
{
    if (share <= 0.0f || x < 0 || y < 0 || x >= static_cast<int>(image_.width) || y >= static_cast<int>(image_.height))
        return;
    const size_t pixel = size_t(y) * image_.width + size_t(x);
    if (!image_.alpha.empty()) {
        // Colours are not multiplied by what they cover.
        const float below = static_cast<float>(image_.alpha[pixel]) / 255.0f, covered = below + share * (1.0f - below);
        image_.alpha[pixel] = static_cast<uint8_t>(std::lround(255.0f * covered));
        share /= covered;
    }
    mixChannels(&image_.rgb[3 * pixel], color, share, 255.0f);
    if (!image_.deep.empty()) mixChannels(&image_.deep[3 * pixel], color, share, 65535.0f);
}

void Canvas::text(float left, float top, std::string_view words, int size)
{
    const int rim = rimOf(size), startX = static_cast<int>(std::floor(left)),
              startY = static_cast<int>(std::floor(top));
    const int base = static_cast<int>(std::lround(font_.ascent(size)));
    // Ink may lean out of its line.
    const int around = rim + size / 2;
    Mask ink(static_cast<int>(std::ceil(font_.width(words, size))) + 2 * around, size + 2 * around);
    const std::vector<uint32_t> points = codePointsOf(words);
    float pen = static_cast<float>(around);
    for (size_t i = 0; i < points.size(); ++i) {
        const Glyph& glyph = font_.glyph(points[i], size);
        stamp(ink, glyph, static_cast<int>(std::lround(pen)) + glyph.left, around + base + glyph.top);
        pen += font_.advance(points[i], i + 1 < points.size() ? points[i + 1] : 0, size);
    }
    Mask wide = widened(ink, rim);
    for (int y = 0; y < ink.height; ++y)
        for (int x = 0; x < ink.width; ++x) {
            mix(startX + x - around, startY + y - around, DARK, RIM_OPACITY * wide.at(x, y));
            mix(startX + x - around, startY + y - around, WHITE, ink.at(x, y));
        }
}

void Canvas::fill(const Eigen::Vector4f& edges, const Eigen::Vector3f& color, float opacity)
{
    const auto part = [](float low, float high, int at) {
        return std::max(std::min(high, static_cast<float>(at + 1)) - std::max(low, static_cast<float>(at)), 0.0f);
    };
    for (int y = static_cast<int>(std::floor(edges[1])); y < static_cast<int>(std::ceil(edges[3])); ++y)
        for (int x = static_cast<int>(std::floor(edges[0])); x < static_cast<int>(std::ceil(edges[2])); ++x)
            mix(x, y, color, opacity * part(edges[0], edges[2], x) * part(edges[1], edges[3], y));
}

}  // namespace knuckle
