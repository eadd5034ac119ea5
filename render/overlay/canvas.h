#pragma once

#include <Eigen/Core>
#include <string_view>

#include "render/overlay/font.h"
#include "render/picture/image.h"

namespace knuckle {

/// Draws over a finished picture. Places are in pixels from its upper left corner, colours as displayed, 0 to 1.
class Canvas {
public:
    Canvas(Image& image, Font& font) : image_(image), font_(font) {}

    /// White letters with a dark rim. @param left, top of the line. @param size height of the line.
    void text(float left, float top, std::string_view words, int size);
    /// @param edges left, top, right, bottom: pixels that they cut are covered in part.
    void fill(const Eigen::Vector4f& edges, const Eigen::Vector3f& color, float opacity = 1.0f);

private:
    /// Mixes one pixel, of 8 and of 16 bits, with a colour.
    void mix(int x, int y, const Eigen::Vector3f& color, float share);

    Image& image_;
    Font& font_;
};

/// The rim of a text of that size [pixels].
int rimOf(int size);

}  // namespace knuckle
