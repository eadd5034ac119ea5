#pragma once

#include <cstdint>
#include <vector>

#include "app/export/exporter.h"

namespace knuckle {

/// The particles that are there in a frame; all lists have a value, or three, for each.
struct ParticlePoints {
    std::vector<float> places, velocities;  ///< [m], [m/s]
    std::vector<uint32_t> ids;
    std::vector<int32_t> bodies, materials;  ///< -1: none.
    std::vector<float> radii;                ///< Half of what it keeps from its like [m].
    std::vector<float> densities;            ///< [kg/m3]; empty: not known.
};

/// @param frame with particles.
ParticlePoints pointsOf(const ExportFrame& frame);

}  // namespace knuckle
