#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "shared/gpu_types.h"

namespace knuckle {

/// Corners of triangles, MARK_TEXELS each, in the order in which they are drawn.
struct Marks {
    std::vector<gpu::vec4> fans;   ///< Half transparent.
    std::vector<gpu::vec4> lines;  ///< Over them.
};

/// Draws marks: places are either relative to the centre of a body, in its axes [m], or on the picture, from its upper
/// left corner in heights of the picture. Widths are in heights of the picture, too.
class MarkPen {
public:
    /// @param color as displayed, 0-1.
    void onBody(uint32_t body, const Eigen::Vector3f& color);
    void onPicture(const Eigen::Vector3f& color);

    /// Half transparent.
    void triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c);
    void line(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float width);
    /// With a dark edge.
    void edgedLine(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float width);
    /// With a dark edge. @param corners of it: 4 for a square, many for a disc.
    void dot(const Eigen::Vector3f& at, float radius, int corners);
    /// Dark letters on the picture. @param left middle of the left end. @param height of a capital letter.
    void text(const Eigen::Vector3f& left, std::string words, float height);

    /// All that was drawn.
    Marks finished() const;

private:
    using Corners = std::vector<gpu::vec4>;
    void corner(Corners& out, const Eigen::Vector3f& here, const Eigen::Vector3f& other, const Eigen::Vector2f& shift,
                const Eigen::Vector3f& color) const;
    void strokeInto(Corners& out, const Eigen::Vector3f& a, const Eigen::Vector3f& b, float width,
                    const Eigen::Vector3f& color) const;
    void fillDot(const Eigen::Vector3f& at, float radius, int corners, const Eigen::Vector3f& color);

    float body_ = 0.0f;
    Eigen::Vector3f color_{1, 1, 1};
    Corners fans_, outlines_, lines_;
};

}  // namespace knuckle
