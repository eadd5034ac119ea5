#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/overlay/font.h"
#include "render/picture/image.h"
#include "render/quantities/color_scale.h"
#include "render/settings.h"

namespace knuckle {

/// Writes captions, labels and bars over finished pictures, after everything else.
class Overlay {
public:
    /// @throws InputError if there is text to write and no font.
    Overlay(const World& world, const RenderSettings& settings);

    bool empty() const { return font_ == nullptr; }
    bool hasScaleBar() const { return settings_.scaleBar; }
    /// @param time of the film [s]. @param pixelsPerMetre at what the camera aims at, for the scale bar.
    void draw(Image& image, double time, float pixelsPerMetre);

private:
    OverlaySettings settings_;
    ColorScale scale_;
    Palette palette_ = Palette::Auto;
    std::unique_ptr<Font> font_;
};

/// 1, 2 or 5 times a power of ten, at most `size`.
float roundLength(float size);

/// Words broken where they say so by a line feed, and at spaces where a line would be wider than `width` [pixels].
std::vector<std::string> linesOf(const std::string& text, const Font& font, int size, float width);

}  // namespace knuckle
