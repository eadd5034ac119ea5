// One thread places a particle between two steps.
#include "render/between/input.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer BeforePositions { vec4 beforePositions[]; };
layout(std430) readonly buffer AfterPositions { vec4 afterPositions[]; };
layout(std430) readonly buffer BeforeVelocities { vec4 beforeVelocities[]; };
layout(std430) readonly buffer AfterVelocities { vec4 afterVelocities[]; };
layout(std430) writeonly buffer BetweenPositions { vec4 betweenPositions[]; };
layout(std430) writeonly buffer BetweenVelocities { vec4 betweenVelocities[]; };

// What bounces has velocities that do not fit its way: they bend it by no more than this share of its length.
const float MOST_BENT = 0.5;

// The part of a velocity that the straight way lacks.
vec3 bend(vec3 velocity, vec3 way)
{
    vec3 lacking = velocity * between.timeStep - way;
    float most = MOST_BENT * length(way), size = length(lacking);
    return size > most ? lacking * (most / size) : lacking;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= between.particleCount) return;
    vec4 a = beforePositions[i], b = afterPositions[i];
    vec3 u = beforeVelocities[i].xyz, v = afterVelocities[i].xyz, way = b.xyz - a.xyz;
    float t = between.part, s = 1.0 - t;
    vec3 place = a.xyz + t * way + s * t * (s * bend(u, way) - t * bend(v, way));
    betweenPositions[i] = vec4(place, max(a.w, b.w));   // what comes or goes in the step is not there
    betweenVelocities[i] = vec4(mix(u, v, t), 0.0);
}
