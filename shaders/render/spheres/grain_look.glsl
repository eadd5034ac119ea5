// What vertices say of grains to their fragments.
#include "math/quaternion.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/spheres/grain_shape.glsl"

flat out vec4 grainRotation;
flat out vec4 grainRadii;
flat out vec4 grainCuts[3];

/// Cuts take a tenth to a third of the radius.
const float LEAST_CUT = 0.08, MOST_CUT = 0.32;

/// Grains cannot turn in the solver; they are shown as if they rolled over the ground where they go.
vec4 rolledTo(vec3 place, float radius)
{
    vec2 angle = place.zx / radius;
    return quaternionProduct(quaternionFromRotation(vec3(angle.x, 0.0, 0.0)),
                             quaternionFromRotation(vec3(0.0, 0.0, -angle.y)));
}

/// @param place in the world. @param color changes. @returns the factor of a particle's drawn radius.
float lookOfGrain(uint particle, vec3 place, float radius, inout uint color)
{
    grainRadii = vec4(0.0);
    grainRotation = vec4(0.0, 0.0, 0.0, 1.0);
    for (int k = 0; k < 3; ++k) grainCuts[k] = vec4(1.0);
    if (!isGrain(particle)) return 1.0;
    float size = grainSize(particle);
    grainRadii = vec4(size * radius * grainStretch(particle), 1.0);
    mat3 toView = transpose(mat3(view.cameraRight.xyz, view.cameraUp.xyz, view.cameraBack.xyz));
    vec4 turn = quaternionProduct(rolledTo(place, radius), grainTurn(particle));
    grainRotation = quaternionProduct(quaternionFromMatrix(toView), turn);
    for (int k = 0; k < 3; ++k)
        grainCuts[k] = 1.0 - mix(vec4(LEAST_CUT), vec4(MOST_CUT), grainParts(particle, 8u + 4u * uint(k)));
    color = packRoots(min(unpackRoots(color) * grainTint(particle), 1.0), 1.0);
    return size;
}
