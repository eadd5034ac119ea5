// One thread places a body, a collider or a point of foam between two steps.
#include "render/between/input.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
uniform samplerBuffer beforeCentres;
uniform samplerBuffer afterCentres;
layout(std430) writeonly buffer BetweenCentres { vec4 betweenCentres[]; };
uniform samplerBuffer beforeRotations;
uniform samplerBuffer afterRotations;
layout(std430) writeonly buffer BetweenRotations { vec4 betweenRotations[]; };
uniform samplerBuffer beforeColliders;   // place, rotation
uniform samplerBuffer afterColliders;
layout(std430) writeonly buffer BetweenColliders { vec4 betweenColliders[]; };
uniform samplerBuffer beforeFoam;
uniform samplerBuffer afterFoam;
layout(std430) writeonly buffer BetweenFoam { vec4 betweenFoam[]; };

// A point of foam that is further away has ended, and another one begun in its room [m/s].
const float FASTEST_FOAM = 30.0;

vec4 moved(samplerBuffer before, samplerBuffer after, uint i)
{
    return mix(texelFetch(before, int(i)), texelFetch(after, int(i)), between.part);
}

// Evenly, but for an error of third order in the angle of one step.
vec4 turned(samplerBuffer before, samplerBuffer after, uint i)
{
    vec4 a = texelFetch(before, int(i)), b = texelFetch(after, int(i));
    return normalize(mix(a, dot(a, b) < 0.0 ? -b : b, between.part));
}

vec4 foam(vec4 a, vec4 b)
{
    bool goesOn = a.w > 0.0 && b.w > 0.0 && distance(a.xyz, b.xyz) < FASTEST_FOAM * between.timeStep;
    return goesOn ? mix(a, b, between.part) : b;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i < between.bodyCount) {
        betweenCentres[i] = moved(beforeCentres, afterCentres, i);
        betweenRotations[i] = turned(beforeRotations, afterRotations, i);
        return;
    }
    i -= between.bodyCount;
    if (i < between.colliderCount) {
        betweenColliders[2u * i] = moved(beforeColliders, afterColliders, 2u * i);
        betweenColliders[2u * i + 1u] = turned(beforeColliders, afterColliders, 2u * i + 1u);
        return;
    }
    i -= between.colliderCount;
    if (i < between.foamCount) betweenFoam[i] = foam(texelFetch(beforeFoam, int(i)), texelFetch(afterFoam, int(i)));
}
