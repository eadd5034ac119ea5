#include "render/marks/mark_pen.h"

#include <stb/stb_easy_font.h>

#include <array>
#include <cmath>
#include <numbers>

#include "shared/draw_types.h"

namespace knuckle {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

constexpr float EDGE = 0.0011f;  // heights of the picture
const Vector3f DARK{0.07f, 0.07f, 0.09f};
constexpr float CAPITAL = 7.0f;  // height of stb's letters

/// In the format of stb_easy_font_print().
struct LetterCorner {
    float x, y, z;
    std::array<uint8_t, 4> color;
};

}  // namespace

void MarkPen::onBody(uint32_t body, const Vector3f& color)
{
    body_ = static_cast<float>(body);
    color_ = color;
}

void MarkPen::onPicture(const Vector3f& color)
{
    body_ = MARK_ON_PICTURE;
    color_ = color;
}

void MarkPen::triangle(const Vector3f& a, const Vector3f& b, const Vector3f& c)
{
    for (const Vector3f& place : {a, b, c}) corner(fans_, place, place, Vector2f::Zero(), color_);
}

void MarkPen::line(const Vector3f& from, const Vector3f& to, float width)
{
    strokeInto(lines_, from, to, width, color_);
}

void MarkPen::edgedLine(const Vector3f& from, const Vector3f& to, float width)
{
    strokeInto(outlines_, from, to, width + 2 * EDGE, DARK);
    line(from, to, width);
}

void MarkPen::dot(const Vector3f& at, float radius, int corners)
{
    fillDot(at, radius + EDGE, corners, DARK);
    fillDot(at, radius, corners, color_);
}

void MarkPen::text(const Vector3f& left, std::string words, float height)
{
    const float scale = height / CAPITAL;
    std::vector<LetterCorner> corners(128 * (words.size() + 1));
    const int quads = stb_easy_font_print(0.0f, -0.5f * CAPITAL, words.data(), nullptr, corners.data(),
                                          static_cast<int>(corners.size() * sizeof(LetterCorner)));
    for (size_t q = 0; q < static_cast<size_t>(quads); ++q) {
        for (const size_t k : {0, 1, 2, 0, 2, 3}) {
            const LetterCorner& at = corners[4 * q + k];
            const Vector3f place = left + scale * Vector3f(at.x, at.y, 0.0f);
            corner(lines_, place, place, Vector2f::Zero(), DARK);
        }
    }
}

Marks MarkPen::finished() const
{
    Marks marks{fans_, outlines_};
    marks.lines.insert(marks.lines.end(), lines_.begin(), lines_.end());
    return marks;
}

void MarkPen::corner(Corners& out, const Vector3f& here, const Vector3f& other, const Vector2f& shift,
                     const Vector3f& color) const
{
    out.push_back({here.x(), here.y(), here.z(), body_});
    out.push_back({other.x(), other.y(), other.z(), 0.0f});
    out.push_back({shift.x(), shift.y(), 0.0f, 0.0f});
    out.push_back({color.x(), color.y(), color.z(), 0.0f});
}

void MarkPen::strokeInto(Corners& out, const Vector3f& a, const Vector3f& b, float width, const Vector3f& color) const
{
    // Extends beyond the ends, so that consecutive strokes have no gaps. Left and right swap at the other end.
    const float half = 0.5f * width;
    const Vector2f left(-half, half), right(-half, -half);
    corner(out, a, b, left, color);
    corner(out, a, b, right, color);
    corner(out, b, a, left, color);
    corner(out, b, a, left, color);
    corner(out, b, a, right, color);
    corner(out, a, b, left, color);
}

void MarkPen::fillDot(const Vector3f& at, float radius, int corners, const Vector3f& color)
{
    const auto rim = [&](int k) {
        const float angle = 2.0f * std::numbers::pi_v<float> * (static_cast<float>(k) + 0.5f) /
                            static_cast<float>(corners);
        return Vector2f(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int k = 0; k < corners; ++k) {
        corner(lines_, at, at, Vector2f::Zero(), color);
        corner(lines_, at, at, rim(k), color);
        corner(lines_, at, at, rim(k + 1), color);
    }
}

}  // namespace knuckle
