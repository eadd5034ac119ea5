#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/export/layers/pixel_motion.h"
#include "app/export/rig.h"
#include "render/layers/scene_things.h"

namespace knuckle {

/// The joints of a figure: where its bones begin.
struct Figure2d {
    std::vector<std::string> names;
    std::vector<std::pair<size_t, size_t>> edges;  ///< From a bone's parent to the bone.
};

Figure2d figureOf(const Model& model);

/// A joint in a picture.
struct KeyPoint {
    Eigen::Vector3d place{0, 0, 0};  ///< In the world [m].
    double column = 0.0, row = 0.0;  ///< [pixels] from the upper left corner; 0 if visibility is.
    int visibility = 0;              ///< 0: outside of the picture, 1: behind something, 2: seen.
};

/// A joint is seen if nothing is in front of it but the two bodies that it joins. @param ids of the pixels.
std::vector<KeyPoint> keyPointsOf(const World& world, const Rig& rig, const std::vector<BodyState>& bodies,
                                  const Layers& layers, const std::vector<PixelIds>& ids);

}  // namespace knuckle
