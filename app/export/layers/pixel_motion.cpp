#include "app/export/layers/pixel_motion.h"

namespace knuckle {

namespace {

Eigen::Vector3d vectorOf(const gpu::vec4& v)
{
    return {v.x, v.y, v.z};
}

Eigen::Isometry3d placeOf(const gpu::vec4& place, const gpu::vec4& turn)
{
    return Eigen::Translation3d(vectorOf(place)) * Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z).normalized();
}

/// Motions back to the frame before.
class EarlierPlaces {
public:
    EarlierPlaces(const World& world, const ViewState& now, const ViewState& before)
        : world_(world), now_(now), before_(before)
    {
        for (size_t b = 0; b < now.bodyCentres.size(); ++b)
            bodies_.push_back(placeOf(before.bodyCentres[b], before.bodyRotations[b]) *
                              placeOf(now.bodyCentres[b], now.bodyRotations[b]).inverse());
        for (size_t c = 0; c + 1 < now.colliderPlaces.size(); c += 2)
            colliders_.push_back(placeOf(before.colliderPlaces[c], before.colliderPlaces[c + 1]) *
                                 placeOf(now.colliderPlaces[c], now.colliderPlaces[c + 1]).inverse());
    }

    Eigen::Vector3d of(const gpu::uvec2& thing, const Eigen::Vector3d& place) const
    {
        if (thing.x == THING_COLLIDER) return colliders_.at(thing.y) * place;
        if (thing.x == THING_BODY) return bodies_.at(thing.y) * place;
        if (thing.x != THING_PARTICLE) return place;
        if (const uint32_t body = world_.particles.at(thing.y).body; body != NO_INDEX) return bodies_[body] * place;
        // What has only just come has not moved.
        const gpu::vec4 &here = now_.positions[thing.y], &there = before_.positions[thing.y];
        return there.w != 0.0f ? place : Eigen::Vector3d(place + vectorOf(there) - vectorOf(here));
    }

private:
    const World& world_;
    const ViewState &now_, &before_;
    std::vector<Eigen::Isometry3d> bodies_, colliders_;
};

/// Through a pixel's middle, with a depth of 1, in the camera's axes.
Eigen::Vector3d rayOf(const Layers& layers, uint32_t column, uint32_t row)
{
    return {(column + 0.5 - 0.5 * layers.width) / layers.camera.focal,
            (0.5 * layers.height - row - 0.5) / layers.camera.focal, -1.0};
}

}  // namespace

Eigen::Vector3d worldPlace(const Layers& layers, uint32_t column, uint32_t row)
{
    const double depth = layers.places[size_t{row} * layers.width + column].w;
    return layers.camera.toWorld * (depth * rayOf(layers, column, row));
}

Eigen::Vector3d pictureOf(const Layers& layers, const LayerCamera& camera, const Eigen::Vector3d& place)
{
    const Eigen::Vector3d own = camera.toWorld.inverse() * place;
    const double scale = camera.focal / -own.z();
    return {0.5 * layers.width + scale * own.x(), 0.5 * layers.height - scale * own.y(), -own.z()};
}

std::vector<Eigen::Vector2f> pixelMotions(const World& world, const Layers& layers, const ViewState& now,
                                          const SeenState* before)
{
    std::vector<Eigen::Vector2f> motions(layers.places.size(), Eigen::Vector2f::Zero());
    if (before == nullptr) return motions;
    // What is behind everything is so far away that only the camera's turn moves it.
    constexpr double FAR_AWAY = 1e9;
    const EarlierPlaces earlier(world, now, before->view);
    for (uint32_t row = 0; row < layers.height; ++row)
        for (uint32_t column = 0; column < layers.width; ++column) {
            const size_t pixel = size_t{row} * layers.width + column;
            Eigen::Vector3d place = layers.camera.toWorld * (FAR_AWAY * rayOf(layers, column, row));
            if (layers.earlier[pixel].w == 1.0f) place = vectorOf(layers.earlier[pixel]);
            else if (layers.places[pixel].w > 0.0f)
                place = earlier.of(layers.things[pixel], worldPlace(layers, column, row));
            const Eigen::Vector2d there = pictureOf(layers, before->camera, place).head<2>();
            motions[pixel] = (Eigen::Vector2d(column + 0.5, row + 0.5) - there).cast<float>();
        }
    return motions;
}

}  // namespace knuckle
