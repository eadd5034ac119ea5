#pragma once

#include <vector>

#include "render/picture/image.h"
#include "render/settings.h"

namespace knuckle {

/// A part of a frame that a camera has for itself.
enum class PanePlace : uint32_t { Whole, Left, Right, Inset };

/// A pane that some shots of a film have.
struct PanePlan {
    PanePlace place;
    RenderSettings settings;  ///< Of its size, its cameras as the shots' only ones, and without text over it.
};

/// All panes of a film; the first of a shot's is that of its own camera. @throws InputError for a picture too small to
/// be divided, and as checkSettings().
std::vector<PanePlan> planPanes(const RenderSettings& settings);
/// Whether frames of a shot have the pane.
bool isShown(PanePlace place, const Shot& shot);
/// Before the names of its buffers in states; empty: nothing.
std::string wordOf(PanePlace place);

/// Both of a height in one, with a line between them.
Image besideEachOther(const Image& left, const Image& right);
/// Puts the small one over a corner, with a border.
void placeInset(Image& image, const Image& inset, Corner corner);

}  // namespace knuckle
