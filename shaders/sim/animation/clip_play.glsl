// State of a clip at a moment (sim/world/animation has the same on the host).
#include "shared/animation_types.h"
#include "math/quaternion.glsl"

uniform samplerBuffer clipTurns;
uniform samplerBuffer clipRoots;

/// Between which keys a moment is. @see ClipTime
struct Moment {
    uint key;
    float part;
    float rounds;
};

/// @param time since the start of the simulation [s]: in double precision, as slow motions would judder otherwise.
Moment momentOf(ClipPlay play, double time)
{
    if (play.keyCount < 2u) return Moment(0u, 0.0, 0.0);
    double last = double(play.keyCount - 1u);
    double key = double(play.firstKey) + double(play.keyRate) * max(time - double(play.at), 0.0);
    double rounds = play.loop == 1u ? floor(key / last) : 0.0;
    key = clamp(key - rounds * last, 0.0, last);
    double before = min(floor(key), last - 1.0);
    return Moment(uint(before), float(key - before), float(rounds));
}

/// Catmull-Rom spline.
vec4 spline(vec4 a, vec4 b, vec4 c, vec4 d, float t)
{
    return b + 0.5 * t * ((c - a) + t * ((2.0 * a - 5.0 * b + 4.0 * c - d) + t * (3.0 * (b - c) + d - a)));
}

/// @param first texel of the first key. @param stride from key to key.
vec4 sampleKeys(samplerBuffer keys, ClipPlay play, Moment at, uint first, uint stride)
{
    int place = int(first + at.key * stride), step = int(stride);
    vec4 b = texelFetch(keys, place), c = play.keyCount > 1u ? texelFetch(keys, place + step) : b;
    vec4 a = at.key > 0u ? texelFetch(keys, place - step) : 2.0 * b - c;
    vec4 d = at.key + 2u < play.keyCount ? texelFetch(keys, place + 2 * step) : 2.0 * c - b;
    return spline(a, b, c, d, at.part);
}

vec4 sampleTurn(ClipPlay play, Moment at, uint turn)
{
    return normalize(sampleKeys(clipTurns, play, at, play.firstTurn + turn, play.bodyCount));
}

vec4 aboutY(float yaw)
{
    return vec4(0, sin(0.5 * yaw), 0, cos(0.5 * yaw));
}

/// How far the first body has turned about y, beyond what its keys say.
float yawOf(ClipPlay play, Moment at)
{
    return play.yaw + at.rounds * play.roundYaw;
}

vec3 pivotOf(ClipPlay play, Moment at)
{
    vec3 root = sampleKeys(clipRoots, play, at, play.firstRoot, 1u).xyz;
    if (play.inPlace == 1u) root.xz = texelFetch(clipRoots, int(play.firstRoot)).xz;
    if (play.roundYaw == 0.0) root += at.rounds * play.roundShift.xyz;
    else root = play.roundShift.xyz + rotate(aboutY(at.rounds * play.roundYaw), root - play.roundShift.xyz);
    return rotate(aboutY(play.yaw), root) + play.shift.xyz;
}
