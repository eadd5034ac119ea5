// How a particle is drawn.
#define NOT_DRAWN 0u
#define DRAWN_AS_POINT 1u
#define DRAWN_AS_QUAD 2u
// Places of the draw arguments.
#define POINT_DRAW 0
#define QUAD_DRAW 1
