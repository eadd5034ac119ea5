// One thread combines the particles' bounds and aims the camera: as set, at the object that it follows, or so that all
// particles and their way down to the ground are visible. These move, so the camera moves smoothly.
#include "render/common/frame.glsl"
#include "render/view/axes.glsl"
#include "render/view/framing.glsl"

layout(local_size_x = 1) in;
layout(std430) readonly buffer BodyCentres { vec4 centres[]; };
layout(std430) readonly buffer ParticleBoxes { ParticleBounds bounds[]; };
layout(std430) buffer View { FrameView view; };

// Stray particles further from the mean than this many standard deviations must not make the rest small.
const float STRAY = 3.0;

Box framedBox()
{
    vec3 low = vec3(1e30), high = vec3(-1e30), sum = vec3(0.0), squares = vec3(0.0);
    float count = 0.0;
    for (uint i = 0u; i < BOUNDS_THREADS; ++i) {
        low = min(low, bounds[i].low.xyz);
        high = max(high, bounds[i].high.xyz);
        sum += bounds[i].sum.xyz;
        count += bounds[i].sum.w;
        squares += bounds[i].squares.xyz;
    }
    if (count == 0.0) {
        low = frame.shadowLimitLow.xyz;
        high = frame.shadowLimitHigh.xyz;
    }
    view.particleLow = vec4(low, 0.0);
    view.particleHigh = vec4(high, 0.0);
    if (count == 0.0) return Box(low, high);
    vec3 mean = sum / count;
    vec3 reach = STRAY * sqrt(max(squares / count - mean * mean, 0.0));
    vec3 middle = 0.5 * (frame.shadowLimitLow.xyz + frame.shadowLimitHigh.xyz) + mean;
    low = max(low, middle - reach) - frame.radius;
    high = min(high, middle + reach) + frame.radius;
    vec3 size = high - low;
    // It will come down, but the picture includes a ground far below only when it comes near.
    low.y = min(low.y, max(frame.groundAlbedo.w, low.y - max(size.x, max(size.y, size.z))));
    if (frame.cameraMode != CAMERA_FRAMES_AROUND) return Box(low, high);
    // Looks from all sides in turn: uses the circle that the corners describe.
    vec2 centre = 0.5 * (low.xz + high.xz);
    float around = 0.5 * length(high.xz - low.xz);
    return Box(vec3(centre.x - around, low.y, centre.y - around), vec3(centre.x + around, high.y, centre.y + around));
}

Box followedBox()
{
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < frame.followedBodyCount; ++i) sum += centres[frame.followedBodyStart + i].xyz;
    return Box(sum / float(frame.followedBodyCount), sum / float(frame.followedBodyCount));
}

Box tracked(Box now)
{
    Box before = Box(view.trackedLow.xyz, view.trackedHigh.xyz);
    if (frame.trackSeconds < 0.0) before = now;
    Box box = Box(mix(before.low, now.low, approachFraction(lessThan(now.low, before.low))),
                  mix(before.high, now.high, approachFraction(greaterThan(now.high, before.high))));
    view.trackedLow = vec4(box.low, 0.0);
    view.trackedHigh = vec4(box.high, 0.0);
    return box;
}

void main()
{
    Box framed = framedBox();
    vec3 back = normalize(frame.cameraPosition.xyz - frame.cameraTarget.xyz);
    vec3 right = perpendicular(back);
    vec3 up = cross(back, right);
    vec3 eye = frame.cameraPosition.xyz;
    if (frame.cameraMode == CAMERA_FOLLOWS) eye += tracked(followedBox()).low;
    if (frame.cameraMode >= CAMERA_FRAMES) eye = placeThatFrames(tracked(framed), right, up, back);
    view.cameraRight = vec4(right, 0.0);
    view.cameraUp = vec4(up, 0.0);
    view.cameraBack = vec4(back, 0.0);
    view.cameraPosition = vec4(eye, 0.0);
}
