#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "sim/world/builder/builder.h"

namespace knuckle {

/// Properties of cloth. Compliances are of each distance [m/N], >= 0; those of Stretch and Shear are the same for a
/// square piece of any size (1 over Young's modulus times thickness).
struct ClothSpec {
    float stretchCompliance = 0.0f;                                 ///< Along the threads.
    float shearCompliance = 1e-3f;                                  ///< Along the diagonals.
    float bendCompliance = std::numeric_limits<float>::infinity();  ///< Between second neighbours; infinite: limp.
    float tearForce = std::numeric_limits<float>::infinity();       ///< Of each distance [N], > 0.
    uint32_t material = 0;                                          ///< Cloth weighs density x diameter x area.
    bool drawn = false;                                             ///< As a surface (World::drawn).
};

/// Cloth before it is placed.
struct ClothSheet {
    std::vector<Vector3f> nodes;                     ///< [m]
    std::vector<float> areas;                        ///< Of each node: its share of the sheet [m2].
    std::vector<Strand> strands;                     ///< Of indices into nodes.
    std::vector<std::array<uint32_t, 3>> triangles;  ///< The same.
    uint32_t columns = 0, rows = 0;                  ///< Of a grid of nodes; 0: it is none.
};

/// A node of cloth tied to a particle that exists.
struct ClothTie {
    uint32_t node = 0;      ///< Into ClothSheet::nodes.
    uint32_t particle = 0;  ///< Of a body, or loose.
};

/// A rectangle in the x-z plane about the origin: rows along x, columns along z, spaced by a diameter or a little less.
/// Node k of row j (z grows with j) is nodes[j * columns + k]. @param width, depth along x and z [m], > 0.
ClothSheet gridSheet(float width, float depth, float diameter, const ClothSpec& spec);

/// A sheet of triangles: coincident vertices are merged, edges longer than a diameter are halved. Edges are joined to
/// rows as straight as possible; triangles give shear, the corners opposite each edge bending.
/// @throws InputError when it would have more than `limit` nodes, or no triangle with an area.
ClothSheet meshSheet(std::span<const Vector3f> vertices, std::span<const std::array<uint32_t, 3>> triangles,
                     float diameter, const ClothSpec& spec, size_t limit);

/// Adds a sheet as an object. @param held nodes that stay in place. @returns the object's index.
/// @throws InputError for a tie longer than a diameter.
uint32_t addCloth(WorldBuilder& builder, const std::string& name, const ClothSheet& sheet, const ClothSpec& spec,
                  std::span<const uint32_t> held, std::span<const ClothTie> ties, const Pose& pose = {},
                  const Vector3f& velocity = {0, 0, 0});

}  // namespace knuckle
