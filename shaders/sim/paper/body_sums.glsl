// The sums over the links of a body: how far its mass centre has moved, and the matrix A of eq. 9.
#include "sim/common/bodies/bodies.glsl"
#include "sim/paper/body_shape.glsl"

struct BodySum {
    vec4 centre;      // sum of masses times moves [kg m]; w: of masses [kg]
    mat3 a;           // [kg m2]
};

void addLink(inout BodySum sum, Body body, uint k, vec3 last)
{
    LinkValues link = fetchLink(body.linkStart + k);
    LinkPosition position = linkPosition(body.linkStart + k, link, k >= body.ownCount);
    sum.centre += link.mass * vec4(position.move - last, 1);
    sum.a += outerProduct(link.mass * position.arm, link.r);
}

/// The move of the centre [m].
vec3 meanMove(vec4 centre)
{
    return centre.xyz / centre.w;
}
