// Constants of contacts that C++ and GLSL share. docs/decisions has the figures that decided them.
#ifndef KNUCKLE_CONTACT_CONSTANTS_H
#define KNUCKLE_CONTACT_CONSTANTS_H

// pairImpulses[].w of a contact that will act but carries nothing yet.
#define ABOUT_TO_ACT (-1.0)

// Relaxation of a mover's contacts: its first value, and its growth until their impulses alternate.
#define INITIAL_RELAXATION 1.5f
#define MOST_RELAXATION 3.2f

// A particle of a lattice counts as beside another up to half a spacing away along an axis, and a little more, so that
// the other is always beside at least one [diameters].
#define BESIDE 0.55f
// The same for a ball or a capsule, whose contacts all act where its surface is nearest: as far as candidates are
// found, which is about as far as a box reaches beyond its next to last particle.
#define ROUND_BESIDE 1.45f
// A box's corner touches a collider if it is nearly as deep as its particle's ball, within this [diameters].
#define CORNER_TIE 0.05f
// A box of one layer stands upright, on the middle of the layer, while it leans by less than this (sine).
#define UPRIGHT 0.05f
// Nearer than this many diameters to a face or an edge of a box of particles, the direction away from it is
// meaningless.
#define LEAST_FLAT 0.3f
// Particles nearer than this many diameters have sunk into each other: their contact holds them while they part.
#define SUNK 0.85f
// Its friction counts at least this many times what recovery may push in a substep as normal impulse.
#define SUNK_GRIP 4.0f
// Contacts that slide more slowly than this stick, up to the limit of static friction [m/s].
#define STICK_SPEED 0.1f
// A particle that leaves faster than this is pushed out by the least share of the recovery [m/s].
#define LEAVING_SPEED 1.0f
#define LEAST_RECOVERY 0.1f
// The same share between limbs of one assembly: parts that leave slowly beside a joint are fast at the end of a limb.
#define LIMB_RECOVERY 0.5f
// The part of their impulse that contacts between limbs of one assembly keep in a substep: jammed limbs store none.
#define LIMB_MEMORY 0.95f
// An impulse above this many times its mean is a shock, which may go as it came.
#define SHOCK 10.0
// The mean falls this many times faster than it rises, so that it does not push particles that part and meet again.
#define MEAN_FALL 4.0

// A collider stays in place while its clip has moved it by no more than this: otherwise rounding would move standing
// colliders, and wake bodies on them. As a turn [rad], and as a fraction of its distance from the origin plus a metre.
#define STANDING 1e-6f
// From the place of a plane to its farthest point that matters, for the effect of its turns [m].
#define PLANE_REACH 1000.0f

// restitutionSizes[]: work groups of contacts, of those with colliders, of movers.
#define RESTITUTION_PAIRS_SIZE 0
#define RESTITUTION_COLLIDER_PAIRS_SIZE 1
#define RESTITUTION_MOVERS_SIZE 2
#define RESTITUTION_SIZES 3

// moverMoves[].w of a body that was let go in this substep, until its contacts are summed.
#define JUST_LET_GO (-1.0)

#endif
