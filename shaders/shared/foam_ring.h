// Elements of foamRing[], the state of the ring of points of foam (sim/fluid/foam/foam_points.glsl).
#ifndef KNUCKLE_FOAM_RING_H
#define KNUCKLE_FOAM_RING_H

#define FOAM_ADVANCE_SIZE 0        // size of the dispatch over all points,
#define FOAM_BIRTH_SIZE 1          // and over those of the step
#define FOAM_RING 2                // slot after the last point; slots ever used; slot of the step's first; stride
#define FOAM_BORN 3                // points of the step
#define FOAM_RING_TEXELS 4
// A step makes at most this part of all points.
#define FOAM_BIRTHS_PART 16u

#endif
