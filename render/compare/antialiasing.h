#pragma once

#include "render/reader/picture.h"

namespace knuckle {

/// Whether a pixel that differs between two pictures of one size lies on an antialiased edge that has moved by less
/// than a pixel. It does by "Anti-aliased Pixel and Intensity Slope Detector" (Vysniauskas 2009) in one of the
/// pictures: it is between a darker and a brighter neighbour, it equals two of its eight neighbours at most, and the
/// darkest or the brightest of them belongs to a flat area in both pictures. And in either picture it lies between its
/// neighbours in the other one, so that the edge is there, too.
bool isAntialiasedEdge(const Picture& a, const Picture& b, uint32_t x, uint32_t y);

}  // namespace knuckle
