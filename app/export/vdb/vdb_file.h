#pragma once

#include <string>
#include <vector>

#include "app/export/surface/surface_mesh.h"

namespace knuckle {

/// What a file of OpenVDB has of a frame.
struct VdbFrame {
    std::vector<Eigen::Vector3f> places, velocities;  ///< Of particles [m], [m/s].
    std::vector<int32_t> ids;
    float pointVoxel = 0.1f;  ///< Of the grid that holds them [m].
    SurfaceMesh fluid = {};   ///< The surface of fluids.
    float fluidVoxel = 0.0f;  ///< Of the grid of its distances [m]; 0: there are no fluids.
};

/// Whether this program has OpenVDB.
bool canWriteVdb();

/// Writes the file; the same frame gives the same bytes. @throws RunError.
void writeVdb(const std::string& path, const VdbFrame& frame);

}  // namespace knuckle
