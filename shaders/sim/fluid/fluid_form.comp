// One thread a slot, at the end of a step: how a fluid particle is drawn as a part of a surface: as a spheroid that is
// flat where its neighbours lie in a sheet or on one side, and long where they lie in a thread (Yu and Turk 2013,
// eqs. 8-16, of whose three axes it has the one that differs most).
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "math/spheroid.glsl"
#include "math/symmetric.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uint, FluidForms, fluidForms);

/// Bounds of the length along the axis over that across it.
const float FLATTEST = 0.4, LONGEST = 2.0;
/// Sum of weights up to which a particle is drawn as a drop of its own, and from which as a part of the fluid; and the
/// radius of such a drop over that of a part.
const float ALONE = 2.0, AMONG = 7.0, DROP = 0.86;
/// Deep in the fluid, 1.5 rest distances from its surface or more, the sum of weights is 20 to 23, and their mean place
/// is not further from the particle than this [reaches].
const float MANY = 18.0, MIDDLE = 0.02;

/// The covariance of the neighbours' places, over the squared reach, the sum of their weights, and their mean place.
mat3 spreadAround(uint k, uint count, out float weights, out vec3 mean)
{
    vec3 x = fetchSlotPosition(k).position, sum = vec3(0), squares = vec3(0), mixed = vec3(0);
    float inverseReach = 1.0 / sim.fluidReach;
    weights = 1.0 - float(paddingOf(count));   // what the list ends with is the particle itself
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) {
            vec3 r = inverseReach * (fetchSlotPosition(slots[c]).position - x);
            float q = min(length(r), 1.0), weight = 1.0 - q * q * q;
            weights += weight;
            sum += weight * r;
            squares += weight * r * r;
            mixed += weight * r.xxy * r.yzz;
        }
    } while (nextTexel(texels));
    mean = sum / weights;
    return symmetricMatrix(squares / weights, mixed / weights) - outerProduct(mean, mean);
}

/// The axis along which a positive matrix is largest, by squaring it.
vec3 largestAxis(mat3 m)
{
    for (int k = 0; k < 5; ++k) {
        m *= 1.0 / max(traceOf(m), 1e-30);
        m = m * m;
    }
    vec3 sizes = diagonalOf(m);
    vec3 axis = sizes.x > max(sizes.y, sizes.z) ? m[0] : sizes.y > sizes.z ? m[1] : m[2];
    return axis / max(length(axis), 1e-30);
}

/// As large as it is over 1: what it becomes in the other direction has the same space.
Spheroid spheroid(vec3 axis, float ratio, float size)
{
    float across = pow(clamp(ratio, FLATTEST, LONGEST), -1.0 / 3.0);
    return Spheroid(axis, size / (across * across), size * across);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    if (!isFluid(i)) return;
    float weights;
    vec3 mean;
    mat3 spread = spreadAround(k, fetchFluidCounts(k, i).fluids, weights, mean);
    if (weights > MANY && dot(mean, mean) < MIDDLE * MIDDLE) {
        fluidForms[i] = INNER;
        return;
    }
    float among = smoothstep(ALONE, AMONG, weights);
    // Rounder where few neighbours say little.
    spread += (0.002 + 0.05 * (1.0 - among)) * mat3(1.0);
    mat3 cofactors = mat3(cross(spread[1], spread[2]), cross(spread[2], spread[0]), cross(spread[0], spread[1]));
    vec3 longAxis = largestAxis(spread), flatAxis = largestAxis(cofactors);
    float most = dot(longAxis, spread * longAxis), least = dot(flatAxis, spread * flatAxis);
    float middle = max(traceOf(spread) - most - least, least), size = mix(DROP, 1.0, among);
    bool isSheet = middle * middle > most * least;
    Spheroid form = isSheet ? spheroid(flatAxis, sqrt(least / sqrt(most * middle)), size)
                            : spheroid(longAxis, sqrt(most / sqrt(least * middle)), size);
    fluidForms[i] = packSpheroid(form);
}
