#include "app/export/layers/key_points.h"

namespace knuckle {

namespace {

/// Whether a pixel shows the bone, or the one that it hangs on.
bool showsBone(const Rig& rig, size_t bone, const PixelIds& ids)
{
    const int32_t parent = rig.model.bones[bone].parent;
    return ids.body == rig.bodies[bone] + 1 || (parent >= 0 && ids.body == rig.bodies[static_cast<size_t>(parent)] + 1);
}

}  // namespace

Figure2d figureOf(const Model& model)
{
    Figure2d figure;
    for (size_t b = 0; b < model.bones.size(); ++b) {
        figure.names.push_back(model.bones[b].name);
        if (const int32_t parent = model.bones[b].parent; parent >= 0)
            figure.edges.emplace_back(static_cast<size_t>(parent), b);
    }
    return figure;
}

std::vector<KeyPoint> keyPointsOf(const World& world, const Rig& rig, const std::vector<BodyState>& bodies,
                                  const Layers& layers, const std::vector<PixelIds>& ids)
{
    std::vector<KeyPoint> points;
    for (size_t b = 0; b < rig.model.bones.size(); ++b) {
        const uint32_t body = rig.bodies[b];
        const Eigen::Vector3f head = rig.model.bones[b].restPose.block<3, 1>(0, 3);
        KeyPoint& point = points.emplace_back();
        point.place = (motionOf(world.bodies[body], bodies[body]) * head).cast<double>();
        const Eigen::Vector3d seen = pictureOf(layers, layers.camera, point.place);
        if (seen.z() <= 0.0 || seen.x() < 0.0 || seen.y() < 0.0 || seen.x() >= layers.width ||
            seen.y() >= layers.height)
            continue;
        point.column = seen.x();
        point.row = seen.y();
        const size_t pixel = static_cast<size_t>(seen.y()) * layers.width + static_cast<size_t>(seen.x());
        const double depth = layers.places[pixel].w;
        point.visibility = depth < 0.0 || depth >= seen.z() || showsBone(rig, b, ids[pixel]) ? 2 : 1;
    }
    return points;
}

}  // namespace knuckle
