// Numbers of fluids' pressures that host tests and shaders share.
#ifndef KNUCKLE_FLUID_CONSTANTS_H
#define KNUCKLE_FLUID_CONSTANTS_H

// Relaxation of fluids' multipliers. They remember, and so ring if it is larger; before the first step, they do not.
#define FLUID_RELAXATION 0.25f
#define FLUID_START_RELAXATION 0.45f
// Part of the inverse of its neighbourhood's matrix that a particle's gradient is corrected by. The rest rubs a little,
// which keeps water at rest quiet.
#define FLUID_EVENNESS 0.85f
// What pairs lack along walls is this many times what walls cover: at 1.1 water at rest sinks along them, at 1.3 it
// rises.
#define FLUID_ALONG_WALLS 1.22f
// How much farther walls and solids are for fluids than they are [rest distances], so that a tank holds its volume; and
// the part that solids cover of what they then would, so that bodies float as deep as they are dense. The first layer
// is neither as even nor as near as a lattice.
#define FLUID_WALL_GAP 0.06f
#define FLUID_SOLID_COVER 0.8f
// Part of the kernel's density that is mixed into the compression that fluids carry on, whenever it is summed up; and
// below which density it is taken as it is.
#define FLUID_MIXING 0.01f
#define FLUID_LOOSE 0.9f
// More is mixed in where fluid flows around something, for what it carries goes wrong sooner there: for each change of
// a length of fluid by itself in a substep, beyond what noise does; and at most.
#define FLUID_FLOW_MIXING 10.0f
#define MOST_FLUID_MIXING 0.1f
// What is mixed in while weight settles before the first step.
#define FLUID_START_MIXING 0.1f
// Part of its last move that a fluid particle repeats in the next pass before the first step. Above 0.95 it overshoots.
// So what falls comes to 10 times what weight gives in a pass.
#define FLUID_MOMENTUM 0.9f
// Bounds of the compression of a fluid: the upper one limits what is corrected at a time and keeps momentum.
#define LEAST_FLUID_ERROR -0.02f
#define MOST_FLUID_ERROR 0.5f
// Between solids, a fluid particle accelerates beyond its own and their largest speed by no more than this [m/s2].
#define MOST_SQUEEZE 300.0f

#endif
