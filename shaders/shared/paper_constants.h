// Constants of the paper's solver that C++ and GLSL share. docs/decisions has the figures that decided them.
#ifndef KNUCKLE_PAPER_CONSTANTS_H
#define KNUCKLE_PAPER_CONSTANTS_H

// Shares of bodies are summed as integers, so that their order makes no difference: parts of one.
#define FRACTION_PARTS 65536.0f
// What is moved at once answers by this much of the sum of its shares at most: by all of it if all pushed the same way.
#define MOST_FRACTION_SUM 1.6f

#endif
