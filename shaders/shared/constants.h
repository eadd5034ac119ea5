// Constants that C++ and GLSL share.
#ifndef KNUCKLE_CONSTANTS_H
#define KNUCKLE_CONSTANTS_H

// Threads in a work group. llvmpipe is 30-40 % slower at 256.
#define GROUP_SIZE 64
// Threads that reduce one body together, where ReductionKind::Group is chosen.
#define BODY_GROUP_SIZE 32
// Values that one thread of a prefix sum adds up.
#define SCAN_CHUNK 64
// Colliders that one particle can touch at a time.
#define COLLIDER_SLOTS 8
// Cells of the grid that are listed once more behind the last, so that no range of neighbours wraps.
#define WRAPPED_CELLS 9
// Cells of the fluids' grid along x that are as long together as one is wide: rows of candidates end closer.
#define FINE_CELLS 4
// Threads in a work group that solves strands: there are few, and each is long.
#define DISTANCE_GROUP_SIZE 8
// Slots whose lists of neighbours lie together.
#define NEIGHBOUR_BLOCK 32u

// ColliderShape of sim/world/world.h.
#define COLLIDER_PLANE 0u
#define COLLIDER_BOX 1u
#define COLLIDER_SPHERE 2u
#define COLLIDER_CAPSULE 3u
#define COLLIDER_MESH 4u
#define COLLIDER_HEIGHTFIELD 5u

// Threads in a work group that solves joints: each takes a tree.
#define TREE_GROUP_SIZE 8
// How a joint lets its body turn: not at all, about one axis, freely; and what a root has that nothing holds.
#define JOINT_STIFF 0u
#define JOINT_HINGE 1u
#define JOINT_BALL 2u
#define JOINT_NONE 3u

// latticeEnds[], beside SurfaceDistance::ends: the particle is of a ball or a capsule; it stands for it at colliders.
#define LATTICE_ENDS 63u
#define IN_ROUND 64u
#define CARRIES_ROUND 128u

// moverStates[]: what a mover does now (sim/common/bodies/mover_info.glsl). Kernels write it, too.
#define MOVER_DYNAMIC 0u
#define MOVER_ANIMATED 1u           // it moves as it is told and answers to nothing
#define MOVER_FIXED 2u
#define MOVER_ASLEEP 3u
// A substep that no other follows.
#define NO_SUBSTEP 0x7fffffffu

// ParticleInfo::body of a fluid particle.
#define IN_FLUID 0xfffffffeu

// Dispatches whose sizes the GPU decides (Stages::dispatches).
#define DISPATCH_PARTICLES 0        // this and the next six: none where contacts were not found anew
#define DISPATCH_CELL_CHUNKS 1
#define DISPATCH_LIST_CHUNKS 2
#define DISPATCH_MOVERS 3
#define DISPATCH_NEW_PAIRS 4
#define DISPATCH_NEW_COLLIDER_PAIRS 5
#define DISPATCH_FAST 6             // particles that find contacts from afar
#define DISPATCH_PAIRS 7
#define DISPATCH_COLLIDER_PAIRS 8
#define DISPATCH_SLOTS 9            // of fluids, where there are emitters or drains
#define DISPATCH_EMIT 10
#define DISPATCH_COUNT 11

// By how much longer contacts are to stay good where few things are fast.
#define CALM 3.0f
// Relaxation of a mover's contacts: where it starts, and how it grows until their impulses turn about.
#define INITIAL_RELAXATION 1.5f
#define MOST_RELAXATION 3.2f

// A body that turns by more than half a radian in a substep (4 (1 - cos 0.5)) loses some of its spin.
#define LONGEST_CHORD 0.49f

// Another is beside a particle of a lattice up to half the lattice away along an axis, and a little more, so that there
// is always one that it is beside [diameters].
#define BESIDE 0.55f
// A box's corner touches a collider where it comes this near to touching as deep as its particle's ball [diameters].
#define CORNER_TIE 0.05f
// A box of one layer stands upright, on the middle of it, while it leans by less than this (sine).
#define UPRIGHT 0.05f
// Nearer than this many diameters to a face or an edge of a box of particles, the direction away from it says nothing.
#define LEAST_FLAT 0.3f
// Nearer than this many diameters, particles have sunk into each other: their contact holds them while they part.
#define SUNK 0.85f
// Its friction has at least this many times what recovery may push in a substep as normal impulse.
#define SUNK_GRIP 4.0f
// What slides more slowly than this sticks, as far as static friction goes [m/s].
#define STICK_SPEED 0.1f
// What leaves faster than this is pushed out of another by no more than the least share of the recovery [m/s].
#define LEAVING_SPEED 1.0f
#define LEAST_RECOVERY 0.1f
// The same share between limbs of one assembly: what parts slowly beside a joint is fast at the end of a limb.
#define LIMB_RECOVERY 0.5f
// What contacts between limbs of one assembly keep of their impulse in a substep: limbs that are jammed store none.
#define LIMB_MEMORY 0.95f
// An impulse of more than so many times its mean is a shock, which may go as it came.
#define SHOCK 10.0
// The mean falls so many times faster than it rises: what parts and meets again is not to be pushed by it.
#define MEAN_FALL 4.0

// Of the multipliers of fluids: at 1 resting water boils.
#define FLUID_RELAXATION 0.45f
// More than this of too much density is not taken back at a time: a limit that keeps momentum.
#define MOST_FLUID_ERROR 1.0f
// Among solids, fluid gets no faster than they and it were by more than this [m/s2].
#define MOST_SQUEEZE 100.0f
// k of s_corr (Macklin and Mueller 2013, eq. 13), as a share of the multipliers: 0.1 at a fifth of the reach.
#define FLUID_REPULSION 0.34f

// pairImpulses[].w of a contact that is going to act but carries nothing yet.
#define ABOUT_TO_ACT (-1.0)

#endif
