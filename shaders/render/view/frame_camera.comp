// One thread combines the particles' bounds and aims the camera: as set, at the object that it follows, or so that all
// particles and their way down to the ground are visible, or those that it frames. These move, so the camera moves
// smoothly.
#include "render/common/frame.glsl"
#include "render/view/axes.glsl"
#include "render/view/framing.glsl"

layout(local_size_x = 1) in;
layout(std430) readonly buffer BodyCentres { vec4 centres[]; };
layout(std430) readonly buffer ParticleBoxes { ParticleBounds bounds[]; };
layout(std430) readonly buffer CameraPlanes { vec4 planes[]; };   // xyz: unit normal; w: offset along it
layout(std430) buffer View { FrameView view; };

#ifdef SOLIDS
#include "render/view/solids.glsl"
#else
vec3 inFrontOfSolids(vec3 target, vec3 eye) { return eye; }
#endif
#include "render/view/framed_box.glsl"
#include "render/view/kept_whole.glsl"
#include "render/view/focus.glsl"

Box followedBox()
{
    vec3 sum = vec3(0.0);
    for (uint i = 0; i < frame.followedBodyCount; ++i) sum += centres[frame.followedBodyStart + i].xyz;
    return boxOf(sum / float(frame.followedBodyCount), sum / float(frame.followedBodyCount));
}

Box tracked(Box now)
{
    Box before = boxOf(view.trackedLow.xyz, view.trackedHigh.xyz);
    if (frame.trackSeconds < 0.0) before = now;
    Box box = boxOf(mix(before.low, now.low, approachFraction(lessThan(now.low, before.low))),
                    mix(before.high, now.high, approachFraction(greaterThan(now.high, before.high))));
    view.trackedLow = vec4(box.low, 0.0);
    view.trackedHigh = vec4(box.high, 0.0);
    return box;
}

// A camera that moves by itself stays in front of floors and walls.
vec3 inFrontOfPlanes(vec3 eye)
{
    for (uint i = 0u; i < frame.cameraPlaneCount; ++i)
        eye += max(frame.cameraClearance + planes[i].w - dot(planes[i].xyz, eye), 0.0) * planes[i].xyz;
    return eye;
}

// Where the camera sees the box; where a plane is in its way, from a side where it is not.
vec3 placeInFront(Box box, inout vec3 back)
{
    bool isNamed = frame.framedBit != 0u;
    Stand before = Stand(view.trackedLow.xyz, view.trackedLow.w);
    vec3 eye = vec3(0.0);
    if (!isNamed) box = tracked(box);
    for (int attempt = 0; attempt < 8; ++attempt) {
        vec3 right = perpendicular(back), up = cross(back, right), wanted, target = 0.5 * (box.low + box.high);
        if (isNamed) {
            Stand stand = keptWhole(before, box, right, up, back);
            target = stand.target;
            wanted = target + stand.distance * back;
        } else {
            wanted = placeThatFrames(box, right, up, back);
        }
        eye = inFrontOfPlanes(wanted);
        if (eye == wanted) return eye;
        back = normalize(eye - target);
    }
    return eye;
}

void main()
{
    Box framed = framedBox();
    vec3 eye = frame.cameraPosition.xyz;
    vec3 back = normalize(eye - frame.cameraTarget.xyz);
    if (frame.cameraMode == CAMERA_FOLLOWS) {
        vec3 followed = tracked(followedBox()).low;
        eye = inFrontOfSolids(followed + frame.cameraTarget.xyz, inFrontOfPlanes(eye + followed));
    }
    if (frame.cameraMode == CAMERA_FRAMES || frame.cameraMode == CAMERA_FRAMES_AROUND) {
        eye = placeInFront(framed, back);
        if (frame.framedBit != 0u) eye = inFrontOfSolids(0.5 * (framed.low + framed.high), eye);
    }
    if (frame.cameraMode == CAMERA_LOOKS) {
        Box seen = tracked(framed);
        back = normalize(eye - 0.5 * (seen.low + seen.high));
    }
    vec3 right = perpendicular(back);
    vec3 up = cross(back, right);
    turn(back, right, frame.cameraTurn.x);
    turn(up, back, frame.cameraTurn.y);
    turn(right, up, frame.cameraTurn.z);
    view.cameraRight = vec4(right, 0.0);
    view.cameraUp = vec4(up, 0.0);
    view.cameraBack = vec4(back, sharpDistance(eye, back));
    view.cameraPosition = vec4(eye, 0.0);
    view.lightDepth.yzw = eye;
}
