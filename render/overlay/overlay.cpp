#include "render/overlay/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/overlay/canvas.h"
#include "render/reader/picture.h"

namespace knuckle {

namespace {

const Eigen::Vector3f WHITE{1, 1, 1}, DARK{0.05f, 0.05f, 0.06f};
// In heights of the picture.
constexpr float MARGIN = 0.04f, TITLE = 0.06f, LABEL = 0.035f, BAR = 0.008f, BAR_EDGE = 0.003f;
constexpr float SCALE_LENGTH = 0.25f;  // of the picture's width, at most
constexpr float COLOR_LOW = 0.7f, COLOR_HIGH = 0.3f, COLOR_WIDTH = 0.025f;
constexpr int COLOR_TICKS = 5;
constexpr double ROUNDING = 1e-6;  // a frame at the time of a cut belongs to what comes [s]

/// Where rows of text go on, from each edge.
class Rows {
public:
    Rows(Image& image, Font& font)
        : canvas(image, font), width(static_cast<float>(image.width)), height(static_cast<float>(image.height)),
          font_(font), down_(MARGIN * height), up_(MARGIN * height), upLeft_(up_), upRight_(up_)
    {
    }

    void text(const std::string& words, TextPlace at, float share)
    {
        const int size = std::max(4, static_cast<int>(std::lround(share * height)));
        std::vector<std::string> lines = linesOf(words, font_, size, width - 2.0f * MARGIN * height);
        const float tall = static_cast<float>(lines.size()) * static_cast<float>(size);
        float top = begin(at, tall);
        for (const std::string& line : lines) {
            canvas.text(leftOf(at, font_.width(line, size)), top, line, size);
            top += static_cast<float>(size);
        }
    }
    /// Room at the lower left corner. @returns its upper end.
    float bottomLeft(float tall) { return begin(TextPlace::BottomLeft, tall); }

    Canvas canvas;
    const float width, height;

private:
    /// The upper end of a block, which takes its room.
    float begin(TextPlace at, float tall)
    {
        switch (at) {
            case TextPlace::Top: return std::exchange(down_, down_ + tall);
            case TextPlace::TopLeft: return std::exchange(downLeft_, downLeft_ + tall) + MARGIN * height;
            case TextPlace::TopRight: return std::exchange(downRight_, downRight_ + tall) + MARGIN * height;
            case TextPlace::Center: return 0.5f * (height - tall) + std::exchange(center_, center_ + tall);
            case TextPlace::Bottom: return height - (up_ += tall);
            case TextPlace::BottomLeft: return height - (upLeft_ += tall);
            case TextPlace::BottomRight: return height - (upRight_ += tall);
        }
        return 0.0f;
    }
    float leftOf(TextPlace at, float wide) const
    {
        const bool left = at == TextPlace::TopLeft || at == TextPlace::BottomLeft;
        const bool right = at == TextPlace::TopRight || at == TextPlace::BottomRight;
        if (left) return MARGIN * height;
        return right ? width - MARGIN * height - wide : 0.5f * (width - wide);
    }

    Font& font_;
    float down_, downLeft_ = 0.0f, downRight_ = 0.0f, center_ = 0.0f, up_, upLeft_, upRight_;
};

std::string lengthText(float metres)
{
    if (metres >= 1.0f) return fmt::format("{:.6g} m", metres);
    return metres >= 0.0099f ? fmt::format("{:.6g} cm", 100.0f * metres) : fmt::format("{:.6g} mm", 1000.0f * metres);
}

void drawScaleBar(Rows& rows, float pixelsPerMetre)
{
    if (!(pixelsPerMetre > 0.0f) || !std::isfinite(pixelsPerMetre)) return;
    const float metres = roundLength(SCALE_LENGTH * rows.width / pixelsPerMetre), length = metres * pixelsPerMetre;
    const float left = MARGIN * rows.height, thick = BAR * rows.height, edge = BAR_EDGE * rows.height;
    const float top = rows.bottomLeft(thick + edge);
    rows.canvas.fill({left - edge, top - edge, left + length + edge, top + thick + edge}, DARK);
    rows.canvas.fill({left, top, left + length, top + thick}, WHITE);
    rows.text(lengthText(metres), TextPlace::BottomLeft, LABEL);
}

void drawColorBar(Rows& rows, Font& font, const ColorScale& scale, Palette palette)
{
    const int size = std::max(4, static_cast<int>(std::lround(LABEL * rows.height)));
    const float top = COLOR_HIGH * rows.height, bottom = COLOR_LOW * rows.height, edge = BAR_EDGE * rows.height;
    const float right = rows.width - MARGIN * rows.height, left = right - COLOR_WIDTH * rows.height;
    rows.canvas.fill({left - edge, top - edge, right + edge, bottom + edge}, DARK);
    for (float y = std::floor(top); y < bottom; ++y) {
        const float low = std::max(y, top), high = std::min(y + 1.0f, bottom);
        const Vector3f color = scaleColor(palette, (bottom - 0.5f * (low + high)) / (bottom - top));
        rows.canvas.fill({left, low, right, high}, color.unaryExpr([](float light) { return encodeSrgb(light); }));
    }
    for (int k = 0; k < COLOR_TICKS; ++k) {
        const float part = static_cast<float>(k) / static_cast<float>(COLOR_TICKS - 1);
        const std::string number = fmt::format("{:.4g}", scale.low + part * (scale.high - scale.low));
        const float middle = bottom + part * (top - bottom);
        rows.canvas.text(left - 0.4f * static_cast<float>(size) - font.width(number, size),
                         middle - 0.5f * static_cast<float>(size), number, size);
    }
    const std::string unit = *scale.unit == '\0' ? "" : fmt::format(" [{}]", scale.unit);
    const std::string name = scale.quantity + unit;
    rows.canvas.text(right - font.width(name, size), top - 2.0f * static_cast<float>(size), name, size);
}

}  // namespace

float roundLength(float size)
{
    const float power = std::pow(10.0f, std::floor(std::log10(size)));
    return power * (size >= 5.0f * power ? 5.0f : size >= 2.0f * power ? 2.0f : 1.0f);
}

std::vector<std::string> linesOf(const std::string& text, const Font& font, int size, float width)
{
    std::vector<std::string> lines;
    std::string line;
    size_t at = 0;
    while (at <= text.size()) {
        const size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const std::string word = text.substr(at, end - at), longer = line.empty() ? word : line + " " + word;
        if (!line.empty() && font.width(longer, size) > width) {
            lines.push_back(line);
            line = word;
        } else {
            line = longer;
        }
        if (end == text.size() || text[end] == '\n') {
            lines.push_back(line);
            line.clear();
        }
        at = end + 1;
    }
    return lines;
}

Overlay::Overlay(const World& world, const RenderSettings& settings) : settings_(settings.overlay)
{
    if (!settings_.hasText()) return;
    font_ = std::make_unique<Font>(settings_.font);
    scale_ = colorScaleOf(world, settings);
    palette_ = paletteOf(settings);
}

void Overlay::draw(Image& image, double time, float pixelsPerMetre)
{
    if (empty()) return;
    Rows rows(image, *font_);
    if (!settings_.title.empty()) rows.text(settings_.title, TextPlace::Top, TITLE);
    if (settings_.scaleBar) drawScaleBar(rows, pixelsPerMetre);
    if (settings_.colorBar) drawColorBar(rows, *font_, scale_, palette_);
    std::string counts;
    if (settings_.frame) counts = fmt::format("frame {}", std::lround(time * settings_.framesPerSecond) + 1);
    if (settings_.time) counts += fmt::format("{}{:.2f} s", counts.empty() ? "" : "   ", time);
    if (!counts.empty()) rows.text(counts, TextPlace::BottomRight, LABEL);
    for (const Caption& caption : settings_.captions) {
        const double from = static_cast<double>(caption.from) - ROUNDING;
        const double to = static_cast<double>(caption.to) - ROUNDING;
        if (time >= from && (caption.to == 0.0f || time < to)) rows.text(caption.text, caption.at, caption.size);
    }
}

}  // namespace knuckle
