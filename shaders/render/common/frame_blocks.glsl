// The host's values of a frame, and the view that the camera's kernels computed from them.
#include "render/common/frame.glsl"

layout(std140) uniform View { FrameView view; };

vec3 toView(vec3 world)
{
    vec3 p = world - view.cameraPosition.xyz;
    return vec3(dot(p, view.cameraRight.xyz), dot(p, view.cameraUp.xyz), dot(p, view.cameraBack.xyz));
}

vec3 directionToView(vec3 world)
{
    return vec3(dot(world, view.cameraRight.xyz), dot(world, view.cameraUp.xyz), dot(world, view.cameraBack.xyz));
}

vec3 directionToWorld(vec3 v)
{
    return v.x * view.cameraRight.xyz + v.y * view.cameraUp.xyz + v.z * view.cameraBack.xyz;
}

// How far the picture is shifted: by a part of a pixel, and so that what is sharp stays where it is from all places of
// the lens [NDC].
vec2 pictureShift()
{
    return vec2(view.cameraRight.w, view.cameraUp.w);
}

// The ray through a window coordinate, in view space, with z = -1: multiplied by a view depth it gives the point.
vec3 viewRay(vec2 windowPosition)
{
    vec2 ndc = 2.0 * windowPosition / vec2(frame.width, frame.height) - 1.0 - pictureShift();
    return vec3(ndc * frame.tanHalfFov * vec2(float(frame.width) / float(frame.height), 1.0), -1.0);
}

// The window coordinate of a point, as texture coordinate.
vec2 pictureOf(vec3 p)
{
    vec2 extent = frame.tanHalfFov * vec2(float(frame.width) / float(frame.height), 1.0);
    return 0.5 * p.xy / (max(-p.z, 1e-6) * extent) + 0.5 + 0.5 * pictureShift();
}

// Clip position of a view-space point. Depth is linear: 0 at the eye, 1 at farDepth; fragments write it themselves if
// the triangle's depth is not exact.
vec4 projectView(vec3 p)
{
    float depth = -p.z;
    float aspect = float(frame.width) / float(frame.height);
    vec2 shift = depth * pictureShift();
    return vec4(p.x / (frame.tanHalfFov * aspect) + shift.x, p.y / frame.tanHalfFov + shift.y,
                (2.0 * depth / frame.farDepth - 1.0) * depth, depth);
}

// Shadow map coordinates of a view-space point, each in -1...1 inside the map; z grows away from the light.
vec3 viewToLight(vec3 p)
{
    return vec3(dot(view.viewToLightX.xyz, p) + view.viewToLightX.w,
                dot(view.viewToLightY.xyz, p) + view.viewToLightY.w,
                dot(view.viewToLightZ.xyz, p) + view.viewToLightZ.w);
}

vec3 worldToLight(vec3 world)
{
    vec3 p = world - view.lightCentre.xyz;
    return vec3(dot(p, view.lightRight.xyz) / view.lightCentre.w, dot(p, view.lightUp.xyz) / view.lightCentre.w,
                -dot(p, frame.keyDirection.xyz) / view.lightDepth.x);
}
