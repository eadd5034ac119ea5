// Constants that C++ and GLSL share.
#ifndef KNUCKLE_CONSTANTS_H
#define KNUCKLE_CONSTANTS_H

// Threads in a work group. llvmpipe is 30-40 % slower at 256.
#define GROUP_SIZE 64
// Threads that reduce one body together, with ReductionKind::Group.
#define BODY_GROUP_SIZE 32
// Values that one thread of a prefix sum adds up.
#define SCAN_CHUNK 64
// Cells of the grid that are listed again after the last, so that no range of neighbours wraps.
#define WRAPPED_CELLS 9
// Cells of the fluids' grid along x per width of a cell: rows of candidates end closer.
#define FINE_CELLS 4
// Threads in a work group that solves strands: there are few strands, and each takes long.
#define DISTANCE_GROUP_SIZE 8
// Slots whose lists of neighbours lie together.
#define NEIGHBOUR_BLOCK 8u

// ColliderShape of sim/world/world.h.
#define COLLIDER_PLANE 0u
#define COLLIDER_BOX 1u
#define COLLIDER_SPHERE 2u
#define COLLIDER_CAPSULE 3u
#define COLLIDER_MESH 4u
#define COLLIDER_HEIGHTFIELD 5u

// TextureWrap of sim/world/matter/skin.h.
#define TEXTURE_REPEAT 0
#define TEXTURE_MIRROR 1
#define TEXTURE_CLAMP 2

// Threads in a work group that solves joints: each takes a tree.
#define TREE_GROUP_SIZE 8
// How a joint lets its body turn: not at all, about one axis, freely; and that of a root that nothing holds.
#define JOINT_STIFF 0u
#define JOINT_HINGE 1u
#define JOINT_BALL 2u
#define JOINT_NONE 3u

// latticeEnds[], besides SurfaceDistance::ends: the particle belongs to a ball or a capsule; it meets colliders for it.
#define LATTICE_ENDS 63u
#define IN_ROUND 64u
#define CARRIES_ROUND 128u

// moverStates[]: current state of a mover (sim/common/bodies/mover_info.glsl). Kernels write it, too.
#define MOVER_DYNAMIC 0u
#define MOVER_ANIMATED 1u           // it moves as its clip says and answers to nothing
#define MOVER_FIXED 2u
#define MOVER_ASLEEP 3u
// A substep after all others.
#define NO_SUBSTEP 0x7fffffffu

// Particle::body of a fluid particle.
#define IN_FLUID 0xfffffffeu

// Dispatches whose sizes the GPU decides (Stages::dispatches).
#define DISPATCH_PARTICLES 0        // this and the next seven: zero without a new search for contacts
#define DISPATCH_CELL_CHUNKS 1
#define DISPATCH_LIST_CHUNKS 2
#define DISPATCH_MOVERS 3
#define DISPATCH_NEW_PAIRS 4
#define DISPATCH_NEW_COLLIDER_PAIRS 5
#define DISPATCH_FAST 6             // particles that look further for contacts
#define DISPATCH_CANDIDATES 7
#define DISPATCH_PAIRS 8
#define DISPATCH_COLLIDER_PAIRS 9
#define DISPATCH_SLOTS 10           // of fluids, if there are emitters or drains
#define DISPATCH_EMIT 11
#define DISPATCH_COUNT 12

// Factor by which contacts should stay valid longer if few things are fast.
#define FAR_SIGHT 3.0f

// A body that turns by more than half a radian in a substep (4 (1 - cos 0.5)) loses some of its spin.
#define LONGEST_CHORD 0.49f

#endif
