// A vertex of a link of a rope: a tube along a cubic through its nodes, with round caps where the rope ends.
#include "render/common/frame_blocks.glsl"
#include "render/common/scale_color.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing_out.glsl"
#include "shared/matter_types.h"

uniform samplerBuffer tubeFrames;           // as in tube_frames.comp
uniform samplerBuffer tubeLooks;            // per node: length of the rope before it and of its link [m], colour
#if defined(COLOR_BY_SPEED) || defined(LAYERS)
uniform usamplerBuffer tubeNodes;
#endif
#ifdef COLOR_BY_SPEED
uniform samplerBuffer velocities;
#endif

out vec3 viewNormal;
out vec3 viewPlace;
out vec3 colorRoots;
out float strandAngle;                      // grows by a turn from strand to strand

/// Strands of the rope, and the length in which each goes around it once, in radii.
const float STRANDS = 3.0, LAY = 10.0;
const float TURN = 6.28318531;
/// The tube's corners are as far outside of the circle as its sides are inside.
const float POLYGON = 2.0 / (1.0 + cos(0.5 * TURN / float(TUBE_SIDES)));

vec3 rootsOf(int node, float stored)
{
#ifdef COLOR_BY_SPEED
    vec3 velocity = texelFetch(velocities, int(texelFetch(tubeNodes, node).x)).xyz;
    return sqrt(scaleColor(length(velocity)));
#else
    return unpackRoots(uint(stored));
#endif
}

/// Between two nodes, from their places and tangents.
vec3 onCubic(vec3 a, vec3 outA, vec3 b, vec3 outB, float s, float t)
{
    return s * s * (1.0 + 2.0 * t) * a + t * t * (1.0 + 2.0 * s) * b + s * t * (s * outA - t * outB);
}

#ifdef LAYERS
uniform samplerBuffer earlierTubeFrames;

vec3 earlierMiddle(int node, int next, float s, float t)
{
    return onCubic(texelFetch(earlierTubeFrames, 3 * node).xyz, texelFetch(earlierTubeFrames, 3 * node + 1).xyz,
                   texelFetch(earlierTubeFrames, 3 * next).xyz, texelFetch(earlierTubeFrames, 3 * next + 1).xyz, s, t);
}
#endif

void main()
{
    int node = gl_InstanceID, ring = gl_VertexID / (TUBE_SIDES + 1) - TUBE_CAP_RINGS;
    vec4 a = texelFetch(tubeFrames, 3 * node), outA = texelFetch(tubeFrames, 3 * node + 1), b = a, outB = outA;
    vec3 sideA = texelFetch(tubeFrames, 3 * node + 2).xyz, sideB = sideA;
    bool whole = a.w == 1.0, alone = !whole && outA.w == 0.0;
    if (whole) {
        b = texelFetch(tubeFrames, 3 * node + 3);
        outB = texelFetch(tubeFrames, 3 * node + 4);
        sideB = texelFetch(tubeFrames, 3 * node + 5).xyz;
    }
    int last = TUBE_RINGS - 1;
    float t = float(clamp(ring, 0, last)) / float(last), s = 1.0 - t;
    vec3 place = onCubic(a.xyz, outA.xyz, b.xyz, outB.xyz, s, t), middle = place;
    vec3 along = normalize(6.0 * s * t * (b.xyz - a.xyz) + s * (s - 2.0 * t) * outA.xyz + t * (t - 2.0 * s) * outB.xyz);
    vec3 side = mix(sideA, sideB, t);
    side = normalize(side - dot(side, along) * along);
    // Towards a cap's pole, if the rope ends here.
    bool caps = ring < 0 ? outA.w == 0.0 : ring > last && (!whole || b.w == 0.0);
    float beyond = caps ? float(max(-ring, ring - last)) / float(TUBE_CAP_RINGS) : 0.0;
    float rise = sin(0.25 * TURN * beyond) * (ring < 0 ? -1.0 : 1.0), wide = cos(0.25 * TURN * beyond);
    float angle = TURN * float(gl_VertexID % (TUBE_SIDES + 1)) / float(TUBE_SIDES);
    vec3 away = cos(angle) * side + sin(angle) * cross(along, side), normal = wide * away + rise * along;
    place += frame.radius * (POLYGON * wide * away + rise * along);
    vec4 looks = texelFetch(tubeLooks, node);
    float turned = (looks.x + t * looks.y + rise * frame.radius) / (LAY * frame.radius);
    strandAngle = STRANDS * (angle - TURN * turned);
    colorRoots = rootsOf(node, looks.z);
    viewPlace = toView(place);
    viewNormal = directionToView(normal);
#ifdef LAYERS
    // What is around the middle goes along with it.
    earlierPlace = place - middle + earlierMiddle(node, whole ? node + 1 : node, s, t);
    NAME_THING(texelFetch(tubeNodes, node).x);
#endif
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(viewPlace);
#endif
    if (!whole && !alone) gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
}
