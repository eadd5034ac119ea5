// Constants of contacts that C++ and GLSL share. docs/decisions has the figures that decided them.
#ifndef KNUCKLE_CONTACT_CONSTANTS_H
#define KNUCKLE_CONTACT_CONSTANTS_H

// pairImpulses[].w of a contact that is going to act but carries nothing yet.
#define ABOUT_TO_ACT (-1.0)

// Relaxation of a mover's contacts: where it starts, and how it grows until their impulses turn about.
#define INITIAL_RELAXATION 1.5f
#define MOST_RELAXATION 3.2f

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

// A collider stays where it is while its clip has it no further away: rounding would else move what stands, and wake
// what lies on it. As a turn [rad], and of its distance from the origin and a metre.
#define STANDING 1e-6f
// From the place of a plane to its farthest point that matters, for what its turns come to [m].
#define PLANE_REACH 1000.0f

// moverMoves[].w of a body that was let go in this substep, until its contacts are summed.
#define JUST_LET_GO (-1.0)

#endif
