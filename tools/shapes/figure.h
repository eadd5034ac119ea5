#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>

#include "sim/rig/model.h"
#include "tools/shapes/distance.h"
#include "tools/shapes/skeleton.h"
#include "tools/shapes/surface_nets.h"

namespace knuckle {

/// The part of a figure at a place of its surface: its skin, its shirt. Each figure has its own numbers.
using Region = uint32_t;

/// Looks of a figure.
struct Figure {
    Distance distance;
    NetGrid grid;
    std::function<Region(const Eigen::Vector3d&)> regionAt;
    /// Linear RGB, 0-1.
    std::function<Eigen::Vector3f(Region, const Eigen::Vector3d&)> colorAt;
    std::function<SkinWeights(Region, const Eigen::Vector3d&)> weightsAt;
};

/// A mesh in which every triangle belongs to one region; vertices on the border of two are duplicated.
struct RegionMesh {
    TriangleMesh mesh;
    std::vector<Region> regions;  ///< Per vertex.
};

/// Cuts triangles where the region changes, so that borders are exact.
RegionMesh cutAtBorders(const TriangleMesh& mesh, const Figure& figure);

/// A model from a skeleton and meshes on it, with normals, colours and weights.
Model makeModel(const std::string& name, const Skeleton& skeleton, std::span<const Figure> figures);

/// Linear RGB of a screen colour of 0 ... 255.
Eigen::Vector3f screenColor(int red, int green, int blue);

}  // namespace knuckle
