// Where a pixel's ray meets a grain: an ellipsoid with faces cut off.
#include "math/quaternion.glsl"
#include "render/spheres/sphere_hit.glsl"

flat in vec4 grainRotation;                 // from its own axes to the view's
flat in vec4 grainRadii;                    // [m]; w: 1 for a grain
flat in vec4 grainCuts[3];                  // of both faces of each axis, over the ellipsoid's reach there

const int GRAIN_AXES = 6;
/// Those of a regular dodecahedron's faces.
const vec3 GRAIN_AXIS[GRAIN_AXES] = vec3[GRAIN_AXES](
    vec3(0.0, 0.525731, 0.850651), vec3(0.0, -0.525731, 0.850651), vec3(0.525731, 0.850651, 0.0),
    vec3(-0.525731, 0.850651, 0.0), vec3(0.850651, 0.0, 0.525731), vec3(0.850651, 0.0, -0.525731));

/// As sphereHit().
bool grainHit(vec3 centre, vec3 ray, out SphereHit hit)
{
    vec4 back = conjugate(grainRotation);
    vec3 direction = rotate(back, ray);
    // From the ray's nearest point to the centre, so that numbers stay small far away.
    float along = dot(centre, ray) / dot(ray, ray);
    vec3 start = rotate(back, along * ray - centre);
    vec3 o = start / grainRadii.xyz, d = direction / grainRadii.xyz;
    float a = dot(d, d), b = dot(o, d), square = b * b - a * (dot(o, o) - 1.0);
    float root = sqrt(max(square, 0.0)), enter = (-b - root) / a, leave = (root - b) / a;
    vec3 normal = (o + enter * d) / grainRadii.xyz;
    for (int k = 0; k < GRAIN_AXES; ++k) {
        vec3 axis = GRAIN_AXIS[k];
        float rate = dot(axis, direction), from = dot(axis, start);
        vec2 cuts = length(axis * grainRadii.xyz) * (k % 2 == 0 ? grainCuts[k / 2].xy : grainCuts[k / 2].zw);
        float side = rate > 0.0 ? -1.0 : 1.0, inverse = 1.0 / (abs(rate) > 1e-6 ? rate : 1e-6);
        float into = ((side > 0.0 ? cuts.x : -cuts.y) - from) * inverse;
        float out0 = ((side > 0.0 ? -cuts.y : cuts.x) - from) * inverse;
        if (into > enter) normal = side * axis;
        enter = max(enter, into);
        leave = min(leave, out0);
    }
    hit.depth = along + enter;
    hit.normal = rotate(grainRotation, normal);
    return square >= 0.0 && enter < leave;
}
