// The box around a body's shape, whose faces away from the eye or the light start the rays of its fragments.
#include "math/quaternion.glsl"
#include "render/common/box_corner.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/thing_out.glsl"
#include "render/shapes/shape_color.glsl"

#ifndef FIRST_SHAPE
#define FIRST_SHAPE 0
#endif

uniform samplerBuffer bodyShapes;           // SHAPE_TEXELS each
uniform samplerBuffer bodyCentres;
uniform samplerBuffer bodyRotations;

flat out vec4 rounded;                      // half sides of the box; w: radius
flat out vec4 source;                       // the eye, or the direction to the light, in the shape's frame; w: colour
#ifdef LIGHT_VIEW
out vec4 boxPoint;                          // in the shape's frame; w: its depth in the light's view
#else
flat out mat3 toShape;                      // from the view's axes
flat out uint finishAlpha;
#ifdef PATTERNS
flat out uint patternSeed;
#endif
#endif

void main()
{
    int first = SHAPE_TEXELS * (FIRST_SHAPE + gl_InstanceID);
    rounded = texelFetch(bodyShapes, first);
    vec4 place = texelFetch(bodyShapes, first + 1);
    vec4 rotation = texelFetch(bodyRotations, int(place.w));
    vec3 middle = texelFetch(bodyCentres, int(place.w)).xyz + rotate(rotation, place.xyz);
    mat3 axes = matrixFromQuaternion(rotation);
    vec3 corner = boxCorner(gl_VertexID) * (rounded.xyz + rounded.w);
    vec3 world = middle + axes * corner;
#ifdef LIGHT_VIEW
    source = vec4(frame.keyDirection.xyz * axes, 0.0);
    gl_Position = vec4(worldToLight(world), 1.0);
    boxPoint = vec4(corner, gl_Position.z);
#else
    vec4 look = texelFetch(bodyShapes, first + 2);
    source = vec4((view.cameraPosition.xyz - middle) * axes, shapeColor(look.xyz));
    finishAlpha = uint(look.w);
#ifdef PATTERNS
    patternSeed = uint(place.w);
#endif
    toShape = transpose(axes) * mat3(view.cameraRight.xyz, view.cameraUp.xyz, view.cameraBack.xyz);
    NAME_THING(place.w);
    gl_Position = projectView(toView(world));
    // The depth of the nearest point that it may have: what is hidden can be skipped before the ray.
    float nearest = max(-toView(middle).z - length(rounded.xyz) - rounded.w, 0.0);
    gl_Position.z = gl_Position.w * (2.0 * nearest / frame.farDepth - 1.0);
#endif
}
