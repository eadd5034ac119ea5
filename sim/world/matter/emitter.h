#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace knuckle {

/// Places of a layer's particles as it leaves a nozzle, and the distance between layers: density, area and speed give
/// the flow, and each particle has its rest volume.
struct Nozzle {
    std::vector<Eigen::Vector3f> points;  ///< [m]
    float pitch = 0.0f;                   ///< Distance between neighbours of a layer [m].
    float layerSpacing = 0.0f;            ///< Between layers [m].
};

/// A square lattice over a disc, in the plane z = 0 around the origin, with the disc's area. No points if the area is
/// less than half of a particle's. @param radius, spacing of the fluid at rest [m], > 0.
Nozzle discNozzle(float radius, float spacing);
/// The same over a rectangle. No points if a side is less than half the spacing. @param width along x, height along y,
/// spacing [m], > 0.
Nozzle rectangleNozzle(float width, float height, float spacing);
/// The nozzle with its z along `direction`, a unit vector, its x level (+X if the direction is vertical), and its
/// middle at `position` [m].
Nozzle placed(Nozzle nozzle, const Eigen::Vector3f& position, const Eigen::Vector3f& direction);

/// A source of fluid particles, which leave it layer by layer. They come from a pool of fixed size.
struct Emitter {
    uint32_t material = 0;  ///< A fluid: index into World::materials.
    Nozzle nozzle;
    Eigen::Vector3f velocity{0, 0, 0};  ///< At the nozzle, perpendicular to its plane [m/s], not zero.
    double start = 0.0, stop = 3600.0;  ///< The first layer leaves at start, the last at stop at the latest [s].
    uint32_t pool = 0;                  ///< Most of its particles that are active at a time; at least a layer.
    /// When the pool has no complete layer left: takes the oldest particles again. Otherwise layers are left out.
    bool takesOldest = false;

    /// Time between two layers [s].
    double interval() const { return nozzle.layerSpacing / static_cast<double>(velocity.norm()); }
    /// Layers that are due until the time `t` [s].
    uint64_t layersUntil(double t) const;
};

}  // namespace knuckle
