// What pixels of layers show: a kind of thing, and its index in the World.
#ifndef KNUCKLE_THING_TYPES_H
#define KNUCKLE_THING_TYPES_H

#define THING_NONE 0u
#define THING_PARTICLE 1u
#define THING_BODY 2u
#define THING_COLLIDER 3u

#endif
