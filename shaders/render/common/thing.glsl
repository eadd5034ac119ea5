// LAYERS: what a pixel shows, and, where vertices move by themselves (MOVES), where its place was in the frame before.
#ifdef LAYERS
#include "shared/thing_types.h"

flat in uint thingIndex;
#ifdef MOVES
in vec3 earlierPlace;
#endif
layout(location = 1) out uvec2 thing;   // THING_*, index
layout(location = 2) out vec4 earlier;  // in the world [m]; w: 1, or 0 where it moves with the thing

#ifdef MOVES
#define EARLIER vec4(earlierPlace, 1.0)
#else
#define EARLIER vec4(0.0)
#endif
#define SHOW_THING(kind) thing = uvec2(kind, thingIndex), earlier = EARLIER
#else
#define SHOW_THING(kind)
#endif
