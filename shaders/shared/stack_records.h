// What kernels of stacks hand each other, and how much of it the host reserves.
#ifndef KNUCKLE_STACK_RECORDS_H
#define KNUCKLE_STACK_RECORDS_H

// Most bodies that a body of a stack may touch.
#define STACK_TOUCHES 8u
// Fewest and most bodies of a stack.
#define LEAST_STACK 6u
#define MOST_STACK 512u
// Bodies whose particles are nearer than this touch; those of a stack have sunk into others no further [diameters].
#define TOUCHING 1e-3f
#define MOST_OVERLAP 0.005f

// Most loops of a stack, touches that are not in its tree, and of a body.
#define MOST_LOOPS 24u
#define BODY_LOOPS 3u

// stackParents[].x of the body that a stack hangs on; NO_INDEX for movers that are in no stack.
#define STACK_ROOT 0xfffffffeu

// Rounds of loops in which a thread of stack_trees looks for trees and rings, and what a body may take of them in one
// round: a driver leaves loops after 65535 (DeviceLimits::loopRounds), and a GPU stops kernels that take long.
#define STACK_TURNS 40000u
#define BODY_TURNS (2u * STACK_TOUCHES + 2u)

// stackSizes[]: work groups of stacks and of their bodies; w: how many.
#define STACKS_SIZE 0
#define STACK_BODIES_SIZE 1

// stackBlocks[] of a body, in texels: inertias of three blocks of three columns, and forces.
#define STACK_EDGE 0u        // stiffness of its contacts with its parent, about its centre
#define STACK_OWN 9u         // stiffness of those with what stands still; then its articulated inertia
#define STACK_FORCE 18u      // on the body
#define STACK_ON_PARENT 20u  // on its parent, about the parent's centre
#define STACK_PASSED 22u     // inertia passed to its parent, about the parent's centre; its motion
#define STACK_STEP 31u       // its last step, a motion
#define STACK_BEFORE 33u     // its move and its rotation delta before the first step
#define STACK_RESIDUAL 35u   // of a stack with loops: the force that its step leaves,
#define STACK_SEARCH 37u     // the direction in which it is looked for next, a motion,
#define STACK_SEARCH_FORCE 39u  // what that needs without loops,
#define STACK_SOLUTION 41u   // the step so far, a motion
#define STACK_LOOPS 43u      // of each loop its stiffness, about the body's centre, and
#define STACK_ON_PARTNER 9u  // its force on the partner, about the partner's centre
#define STACK_LOOP_TEXELS 11u
#define STACK_TEXELS 76u

#endif
