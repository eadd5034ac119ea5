#pragma once

#include <array>
#include <memory>

#include "render/compare/differences.h"

namespace knuckle {

/// What is not compared of two pictures.
struct IgnoredParts {
    std::vector<PixelBox> boxes;  ///< May go beyond the picture.
    /// Of the pictures' size: what is black or fully transparent in it is not compared. None: all is.
    std::shared_ptr<const Picture> mask;
    std::vector<std::array<uint8_t, 3>> colors;  ///< Opaque pixels of this colour in either picture, sRGB.

    bool any() const { return !boxes.empty() || mask || !colors.empty(); }
};

/// @param a, b of one size. @returns per pixel whether it is ignored, or nothing where all are compared.
/// @throws InputError for a mask of another size, and where nothing is left to compare.
std::vector<uint8_t> findIgnored(const Picture& a, const Picture& b, const IgnoredParts& parts);

}  // namespace knuckle
