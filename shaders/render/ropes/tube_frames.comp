// One thread a rope: the place, the tangent and a direction across at each node, carried along without turning about
// the rope, so that what is seen on it does not swim.
#include "render/common/frame.glsl"
#include "shared/matter_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) writeonly buffer TubeFrames { vec4 frames[]; };  // three a node: place, w: 1 if the next link is whole;
                                                                // tangent [m a link], w: 1 if the one before is; side
uniform samplerBuffer tubeRopes;            // two each: first node, nodes; direction of its first link at the start
uniform usamplerBuffer tubeNodes;           // particle, its next link's distance
uniform samplerBuffer positions;
#ifdef TEARS
uniform samplerBuffer distanceStates;       // z: 1 if torn
#endif

bool isWhole(uvec2 node)
{
#ifdef TEARS
    return node.y == NEVER_TORN || texelFetch(distanceStates, int(node.y)).z == 0.0;
#else
    return true;
#endif
}

/// A direction across that turns with `from`, a unit vector, to `to` by the shortest way.
vec3 carried(vec3 side, vec3 from, vec3 to)
{
    return side - dot(side, to) / max(1.0 + dot(from, to), 1e-3) * (from + to);
}

vec3 anyAcross(vec3 direction)
{
    vec3 other = abs(direction.y) < 0.7 ? vec3(0, 1, 0) : vec3(1, 0, 0);
    return normalize(cross(direction, other));
}

void main()
{
    int rope = int(gl_GlobalInvocationID.x);
    if (rope >= textureSize(tubeRopes) / 2) return;
    vec4 which = texelFetch(tubeRopes, 2 * rope);
    int first = int(which.x), last = first + int(which.y) - 1;
    vec3 heading = texelFetch(tubeRopes, 2 * rope + 1).xyz, side = anyAcross(heading);
    uvec2 node = texelFetch(tubeNodes, first).xy;
    vec3 before = vec3(0), here = texelFetch(positions, int(node.x)).xyz, next = here;
    bool wholeBefore = false;
    for (int k = first; k <= last; ++k) {
        bool whole = k < last && isWhole(node);
        if (k < last) {
            node = texelFetch(tubeNodes, k + 1).xy;
            next = texelFetch(positions, int(node.x)).xyz;
        }
        vec3 tangent = whole && wholeBefore ? 0.5 * (next - before) : whole ? next - here
                                          : wholeBefore ? here - before : vec3(0);
        float size = length(tangent);
        vec3 now = size > 0.0 ? tangent / size : heading;
        side = carried(side, heading, now);
        side = normalize(side - dot(side, now) * now);
        heading = now;
        frames[3 * k] = vec4(here, whole ? 1.0 : 0.0);
        frames[3 * k + 1] = vec4(size > 0.0 ? tangent : heading * 1e-6, wholeBefore ? 1.0 : 0.0);
        frames[3 * k + 2] = vec4(side, 0.0);
        before = here;
        here = next;
        wholeBefore = whole;
    }
}
