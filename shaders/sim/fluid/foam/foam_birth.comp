// One thread a point that the step makes: beside the way that its particle has come, almost as fast.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/foam/foam_points.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer foamFlows;
uniform usamplerBuffer foamRing;
uniform usamplerBuffer foamParents;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, FoamPlaces, newFoamPlaces);
BUFFER(vec4, FoamMoves, newFoamMoves);

const vec2 LIFE = vec2(1.0, 3.0);   // [s]
// How much points of a particle part, in foamSpeed().
const float SPREAD = 0.3;

void main()
{
    uint n = gl_GlobalInvocationID.x;
    if (n >= texelFetch(foamRing, FOAM_BORN).x) return;
    uint k = texelFetch(foamParents, int(n)).x, i = fetchSlotParticle(k);
    vec3 x = texelFetch(positions, int(i)).xyz, v = texelFetch(foamFlows, int(k)).xyz;
    uint hash = mixedHash(mixedHash(mixedHash(STATE_HASH_LOW, i), counters[0].substep), n);
    float turn = 6.2831853 * nextRandom(hash), out1 = sqrt(nextRandom(hash)), back = nextRandom(hash);
    vec3 way = v / max(length(v), 1e-20), side = abs(way.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    vec3 e1 = normalize(cross(way, side)), e2 = cross(way, e1), off = out1 * (cos(turn) * e1 + sin(turn) * e2);
    float slower = 1.0 - 0.1 * nextRandom(hash);
    uint slot = (ringStateOf(texelFetch(foamRing, FOAM_RING)).start + n) % sim.foamCapacity;
    newFoamPlaces[slot] = vec4(x + 0.5 * sim.fluidSpacing * off - back * stepTime() * v, 0);
    newFoamMoves[slot] = vec4(slower * v + SPREAD * foamSpeed() * off, mix(LIFE.x, LIFE.y, nextRandom(hash)));
}
