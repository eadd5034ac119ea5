// How a particle is drawn: for the camera as a point, as a quad or not at all, and for the light or not.
#define DRAWN_AS_POINT 1u
#define DRAWN_AS_QUAD 2u
#define CASTS_SHADOW 4u

uvec3 listCounts(uint how)
{
    return uvec3(how & DRAWN_AS_POINT, (how & DRAWN_AS_QUAD) >> 1, (how & CASTS_SHADOW) >> 2);
}
