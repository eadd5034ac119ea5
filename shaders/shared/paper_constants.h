// Constants of the paper's solver that C++ and GLSL share. docs/decisions has the figures that decided them.
#ifndef KNUCKLE_PAPER_CONSTANTS_H
#define KNUCKLE_PAPER_CONSTANTS_H

// Fractions of bodies are summed as integers, so that their order makes no difference: units per 1.
#define FRACTION_PARTS 65536.0f
// Particles pushed together answer by at most this much of the sum of their fractions: by all of it with equal pushes.
#define MOST_FRACTION_SUM 1.6f

#endif
