// Constants of the paper's solver that C++ and GLSL share. docs/physics.md has the figures that decided them.
#ifndef KNUCKLE_PAPER_CONSTANTS_H
#define KNUCKLE_PAPER_CONSTANTS_H

// Shares of bodies are summed as integers, so that their order makes no difference: parts of one.
#define SHARE_PARTS 65536.0f
// ... and the bit that says that some of them overlap deeply with something.
#define BODY_CAUGHT 0x80000000u
// ... which slows the body: the time in which it loses all but 1/e of its speed, but that of its fall [s].
#define CAUGHT_TIME 0.005f
// What is moved at once answers by this much of the sum of its shares at most: by all of it if all pushed the same way.
#define SHARES_AT_ONCE 1.6f
// An overlap deeper than this at the start of a substep [diameters] opens no faster than CALM_SPEED [m/s].
#define CALM_OVERLAP 0.05f
#define CALM_SPEED 0.25f

#endif
