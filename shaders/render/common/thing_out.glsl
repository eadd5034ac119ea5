// LAYERS: what vertices say to thing.glsl.
#ifdef LAYERS
flat out uint thingIndex;
#ifdef MOVES
out vec3 earlierPlace;
#endif
#define NAME_THING(index) thingIndex = uint(index)
#else
#define NAME_THING(index)
#endif
