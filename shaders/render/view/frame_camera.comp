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
float freeWay(vec3 target, vec3 way) { return 1.0; }
vec3 inFrontOfSolids(vec3 target, vec3 eye) { return eye; }
#endif
#include "render/view/around_solids.glsl"
#include "render/view/framed_box.glsl"
#ifdef FRAMED
#include "render/view/kept_whole.glsl"
#endif
#include "render/view/planes.glsl"
#include "render/view/follow.glsl"
#include "render/view/focus.glsl"

// Where the camera sees the box; where a plane is in its way, from a side where it is not.
vec3 placeInFront(Box box, inout vec3 back)
{
    vec3 eye = vec3(0.0);
#ifdef FRAMED
    bool isNamed = frame.framedBit != 0u;
    Stand before = Stand(view.trackedLow.xyz, view.trackedLow.w);
    if (!isNamed) box = tracked(box);
#else
    box = tracked(box);
#endif
    for (int attempt = 0; attempt < 8; ++attempt) {
        vec3 right = perpendicular(back), up = cross(back, right), target = 0.5 * (box.low + box.high);
        vec3 wanted = placeThatFrames(box, right, up, back);
#ifdef FRAMED
        if (isNamed) {
            Stand stand = keptWhole(before, box, right, up, back);
            target = stand.target;
            wanted = target + stand.distance * back;
        }
#endif
        eye = inFrontOfPlanes(wanted);
        if (eye == wanted) return eye;
        back = normalize(eye - target);
    }
    return eye;
}

// About how far from its middle the camera sees all of a box.
float distanceThatFrames(Box box, vec3 back)
{
    vec3 centre = 0.5 * (box.low + box.high), right = perpendicular(back);
    box.low -= centre;
    box.high -= centre;
    return dot(placeThatFrames(box, right, cross(back, right), back), back);
}

void main()
{
    Box framed = framedBox();
    vec3 eye = frame.cameraPosition.xyz;
    vec3 back = normalize(eye - frame.cameraTarget.xyz);
    if (frame.cameraMode == CAMERA_FOLLOWS) eye = placeThatFollows(back);
    if (frame.cameraMode == CAMERA_FRAMES || frame.cameraMode == CAMERA_FRAMES_AROUND) {
        vec3 middle = 0.5 * (framed.low + framed.high);
        bool isNamed = frame.framedBit != 0u;
        if (isNamed) back = turnedAround(back, turnAroundSolids(middle, distanceThatFrames(framed, back) * back));
        eye = placeInFront(framed, back);
        if (isNamed) eye = inFrontOfSolids(middle, eye);
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
