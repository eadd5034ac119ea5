// Inputs of what is drawn of cloth, ropes and soft bodies, shared by the renderer's host code and shaders.
#ifndef KNUCKLE_MATTER_TYPES_H
#define KNUCKLE_MATTER_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Instead of a distance: there is none that can tear.
#define NEVER_TORN 0xffffffffu
// Particles with which a point of a soft body's surface moves.
#define SOFT_LINKS 16
// Threads of a weave along the side of a cell of a grid.
#define THREADS_A_CELL 4.0f
// Vertices of the strip around one edge of a sheet, half a tube.
#define HEM_STRIP 10

// Half the thickness of cloth, in diameters of a particle.
#define CLOTH_HALF 0.2f

// A tube of a rope: rings a link, its ends being two of them, and rings of a cap; sides of a ring.
#define TUBE_RINGS 5
#define TUBE_CAP_RINGS 3
#define TUBE_SIDES 16

// A sheet of cloth.
struct ClothSheet {
    uint firstNode;
    uint columns;
    uint rows;                  // 0: it is no grid; its vertices are its nodes
    uint firstCell;             // of a grid: cells between its nodes, along rows
    uint steps;                 // of the surface, to the side of a cell
    uint unused0;
    uint unused1;
    uint unused2;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
