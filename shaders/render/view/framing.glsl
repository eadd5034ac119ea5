// The box that the camera shows: how fast the camera follows it, and a place from which all of it is visible.
#include "render/common/frame.glsl"

// Times in which the framed box grows and shrinks, and a followed object is caught up with, up to a share 1/e [s].
const float GROWING = 0.12;
const float SHRINKING = 0.6;
const float FOLLOWING = 0.1;

struct Box {
    vec3 low, high;
};

// How far the camera may lag behind named particles: into the margin that they leave in the picture, so that no part
// is cut off, and so that they fill no less than two thirds of their share. In their own sizes.
const float LAG_INTO_MARGIN = 0.4;
const float LAG_AROUND = 0.5;

// The part of the way to `now` that this frame covers. `outward`: where the box grows.
vec3 approachFraction(bvec3 outward)
{
    if (frame.trackSeconds < 0.0) return vec3(1.0);
    vec3 time = frame.cameraMode == CAMERA_FOLLOWS ? vec3(FOLLOWING) : mix(vec3(SHRINKING), vec3(GROWING), outward);
    return 1.0 - exp(-frame.trackSeconds / time);
}

// A lag, bent so that it never comes to its limit and never stops abruptly.
vec3 bentLag(vec3 lag, vec3 limit)
{
    limit = max(limit, vec3(1e-6));
    return limit * tanh(clamp(lag / limit, -9.0, 9.0));
}

// The tracked box of named particles: behind their real one by no more than keeps them in the picture.
Box keptNear(Box box, Box now)
{
    vec3 size = now.high - now.low;
    vec3 into = LAG_INTO_MARGIN * (1.0 / frame.frameShare - 1.0) * size, around = LAG_AROUND * size;
    vec3 low = box.low - now.low, high = box.high - now.high;
    return Box(now.low + bentLag(low, mix(around, into, greaterThan(low, vec3(0.0)))),
               now.high + bentLag(high, mix(into, around, greaterThan(high, vec3(0.0)))));
}

// The place where the four sides of the view touch the box, or two of them if the proportions differ.
vec3 placeThatFrames(Box box, vec3 right, vec3 up, vec3 back)
{
    vec2 slope = frame.frameShare * frame.tanHalfFov * vec2(float(frame.width) / float(frame.height), 1.0);
    vec2 most = vec2(-1e30), least = vec2(1e30);
    for (int corner = 0; corner < 8; ++corner) {
        vec3 p = mix(box.low, box.high, vec3(corner & 1, corner >> 1 & 1, corner >> 2));
        vec2 side = vec2(dot(p, right), dot(p, up));
        most = max(most, side + slope * dot(p, back));
        least = min(least, side - slope * dot(p, back));
    }
    vec2 middle = 0.5 * (most + least), away = 0.5 * (most - least) / slope;
    return middle.x * right + middle.y * up + max(away.x, away.y) * back;
}
