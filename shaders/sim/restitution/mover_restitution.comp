// One thread a mover: adds what its collisions' impulses change to its velocity, and counts them.
#define PAIR_IMPULSES pairRestitutions
#define COLLIDER_IMPULSES colliderRestitutions
#include "sim/common/kernel.glsl"
#include "sim/common/impulse_sums.glsl"
#include "math/quaternion.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer moverInfo;
uniform samplerBuffer moverRotations;
uniform samplerBuffer bodyInertias;      // two a body, inverse: xx, yy, zz, 1 / mass; xy, xz, yz
uniform samplerBuffer lastMoverVelocities;
BUFFER(vec4, MoverVelocities, moverVelocities);
BUFFER(float, MoverRestitutionSplits, moverRestitutionSplits);
READ_BUFFER(Counters, CountersBlock, counters);

/// Of the velocity field of a body, for impulses that sum to p and p r^T in its own axes.
Field velocityChange(uint body, Field impulse)
{
    vec4 diagonal = texelFetch(bodyInertias, int(2u * body));
    vec3 other = texelFetch(bodyInertias, int(2u * body + 1u)).xyz;
    mat3 inverse = mat3(diagonal.x, other.x, other.y, other.x, diagonal.y, other.z, other.y, other.z, diagonal.z);
    mat3 axes = matrixFromQuaternion(texelFetch(moverRotations, int(body)));
    mat3 a = impulse.f * transpose(axes);   // sum of p (R r)^T
    vec3 torque = vec3(a[1].z - a[2].y, a[2].x - a[0].z, a[0].y - a[1].x);
    vec3 spin = axes * (inverse * (torque * axes));
    return Field(diagonal.w * impulse.t, mat3(cross(spin, axes[0]), cross(spin, axes[1]), cross(spin, axes[2])));
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    uvec4 info = texelFetch(moverInfo, int(m));
    float inverseMass = uintBitsToFloat(info.w);
    if (inverseMass == 0.0) return;
    Sum sum = contactSum(info, counters[0].listParity);
    moverRestitutionSplits[m] = sum.acting;
    Field v = fetchField(lastMoverVelocities, m);
    Field change = Field(inverseMass * sum.impulse.t, mat3(0));
    if (m < sim.bodyCount) change = velocityChange(m, sum.impulse);
    Field next = Field(v.t + change.t, v.f + change.f);
    STORE_FIELD(moverVelocities, m, next)
}
