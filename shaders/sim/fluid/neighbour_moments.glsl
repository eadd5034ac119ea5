// How the fluid neighbours of a particle lie around it: the fraction of the kernel that they fill, and the sum of
// r grad W over them, whose inverse evens gradients (Randles and Libersky 1996).
#include "math/symmetric.glsl"

/// In units of the kernel's height and steepness; the diagonal and yz, zx, xy.
struct Moments {
    float fraction;
    vec3 diagonal, mixed;
};

/// Of the first `count` neighbours. What the list ends with is subtracted again.
Moments noMoments(uint count)
{
    return Moments(1.0 - float(paddingOf(count)), vec3(0), vec3(0));
}

/// Adds a neighbour at -r from the particle, and gives the slope of the kernel there.
vec3 addMoment(inout Moments sums, vec3 r, float inverseReach)
{
    float a = 1.0 - min(sqrt(dot(r, r)) * inverseReach, 1.0);
    vec3 slope = a * a * a * r;
    sums.fraction += fluidShape(a);
    sums.diagonal += slope * r;
    sums.mixed += slope.yzx * r.zxy;
    return slope;
}

mat3 momentMatrix(Moments sums)
{
    float steepness = -fluidSteepness();
    return symmetricMatrix(steepness * sums.diagonal, steepness * sums.mixed.zyx);
}
