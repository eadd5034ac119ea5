#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace knuckle {

struct ParticleRange {
    uint32_t first = 0, end = 0;
};

/// A sheet of cloth that is drawn as a smooth surface.
struct ClothSurface {
    std::vector<uint32_t> nodes;                     ///< Particles.
    std::vector<std::array<uint32_t, 3>> triangles;  ///< Indices into nodes; of a grid two a cell, cells along rows.
    uint32_t columns = 0, rows = 0;                  ///< Of a grid, node k of row j is nodes[j * columns + k]; 0: none.
};

/// How many particles of a soft body a point of its surface moves with.
inline constexpr size_t HULL_LINKS = 16;

/// A point of the surface of a soft body: the sum of weight times place of some of its particles.
struct HullVertex {
    std::array<uint32_t, HULL_LINKS> particles{};  ///< Within the soft body; the nearest one is the first.
    std::array<float, HULL_LINKS> weights{};       ///< Sum 1.
};

/// A closed surface around the particles of a soft body.
struct SoftHull {
    std::vector<HullVertex> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;  ///< Counter-clockwise from outside.
};

struct SoftSurface {
    uint32_t softBody = 0;  ///< Index into World::softBodies.
    std::shared_ptr<const SoftHull> hull;
};

/// What is drawn otherwise than as spheres, apart from fluids and rigid bodies.
struct DrawnMatter {
    std::vector<ClothSurface> cloth;
    std::vector<uint32_t> ropes;  ///< Indices into World::strands: drawn as tubes.
    std::vector<SoftSurface> soft;
    std::vector<ParticleRange> grains;  ///< Drawn with faces, no two alike.
};

/// Binds places of the rest pose to particles such that they follow every stretch, turn and shear of these exactly
/// (moving least squares, with a little resistance where particles are in a plane or a line). @param particles of the
/// soft body at rest, not empty [m]. @param reach of a particle's weight, beyond the nearest one [m].
std::vector<HullVertex> bindHull(std::span<const Eigen::Vector3f> places, std::span<const Eigen::Vector3f> particles,
                                 float reach);

struct World;

/// Validates what is drawn of matter. @throws std::logic_error.
void validateDrawnMatter(const World& world);

}  // namespace knuckle
