// The box that the camera shows: how fast the camera follows it, and a place from which all of it is visible.
#include "render/common/frame.glsl"

// Times in which the framed box grows and shrinks, and a followed object is caught up with, up to a share 1/e [s].
const float GROWING = 0.12;
const float SHRINKING = 0.6;
const float FOLLOWING = 0.1;
// How far behind a followed object may be at most, as a share of half the picture.
const float BEHIND = 0.25;

// A lag, bent so that it never comes to its limit and never stops abruptly.
float bent(float lag, float limit)
{
    limit = max(limit, 1e-4);
    return limit * tanh(clamp(lag / limit, -9.0, 9.0));
}

// A box whose corners are cut off across, by as much of each edge: those where x + y + z, -x + y + z, x - y + z and
// x + y - z are largest, and those where they are smallest [m].
struct Box {
    vec3 low, high;
    vec4 cutsMost, cutsLeast;
};

Box boxOf(vec3 low, vec3 high)
{
    return Box(low, high, vec4(0.0), vec4(0.0));
}

// The part of the way to `now` that this frame covers. `outward`: where the box grows.
vec3 approachFraction(bvec3 outward)
{
    if (frame.trackSeconds < 0.0) return vec3(1.0);
    vec3 time = frame.cameraMode == CAMERA_FOLLOWS ? vec3(FOLLOWING) : mix(vec3(SHRINKING), vec3(GROWING), outward);
    return 1.0 - exp(-frame.trackSeconds / time);
}

// Bit 0 of a corner: at the largest x; then y, z.
float cutOf(Box box, int corner)
{
    bool most = bitCount(corner) > 1;
    int other = most ? 7 ^ corner : corner;   // 0, 1, 2 or 4
    int cut = other == 4 ? 3 : other;
    return most ? box.cutsMost[cut] : box.cutsLeast[cut];
}

// How far out to the right and up a side of the view must be to have the box within it, and to the left and down, where
// it passes the origin's depth. `slope` of the sides.
vec4 limitsOf(Box box, vec3 right, vec3 up, vec3 back, vec2 slope)
{
    vec2 most = vec2(-1e30), least = vec2(1e30);
    for (int point = 0; point < 24; ++point) {
        int corner = point / 3, axis = point % 3;
        vec3 inward = vec3(axis == 0, axis == 1, axis == 2) * min(box.high - box.low, cutOf(box, corner));
        bvec3 isHigh = bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
        vec3 p = mix(box.low + inward, box.high - inward, isHigh);
        vec2 side = vec2(dot(p, right), dot(p, up));
        most = max(most, side + slope * dot(p, back));
        least = min(least, side - slope * dot(p, back));
    }
    return vec4(most, least);
}

// Of the sides of a picture's part.
vec2 slopeOf(float share)
{
    return share * frame.tanHalfFov * vec2(float(frame.width) / float(frame.height), 1.0);
}

// The place where the four sides of the view touch the box, or two of them if the proportions differ.
vec3 placeThatFrames(Box box, vec3 right, vec3 up, vec3 back)
{
    vec2 slope = slopeOf(frame.frameShare);
    vec4 limits = limitsOf(box, right, up, back, slope);
    vec2 most = limits.xy, least = limits.zw;
    vec2 middle = 0.5 * (most + least), away = 0.5 * (most - least) / slope;
    return middle.x * right + middle.y * up + max(away.x, away.y) * back;
}
