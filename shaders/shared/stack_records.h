// What kernels of stacks hand each other, and how much of it the host reserves.
#ifndef KNUCKLE_STACK_RECORDS_H
#define KNUCKLE_STACK_RECORDS_H

// Most bodies that a body of a stack may touch.
#define STACK_TOUCHES 8u
// Fewest bodies of a stack.
#define LEAST_STACK 6u
// Bodies whose particles are nearer than this touch; those of a stack have sunk into others no further [diameters].
#define TOUCHING 1e-3f
#define MOST_OVERLAP 0.005f

// stackParents[] of the body that a stack hangs on; NO_INDEX for movers that are in no stack.
#define STACK_ROOT 0xfffffffeu

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
#define STACK_TEXELS 35u

#endif
