// One thread a mover: how gravity, force fields and the air accelerate it in the substep. Fields are evaluated where
// its velocity brings it, as BDF2 takes forces at the substep's end.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/force_fields.glsl"
#ifdef CLOTH
#include "sim/forces/cloth_drag.glsl"
#endif

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverVelocities;
uniform samplerBuffer moverDrags;   // along the axes of the body [1/m]
BUFFER(vec4, MoverAccelerations, moverAccelerations);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    vec3 velocity = fetchField(moverVelocities, m).t, acceleration = sim.gravity.xyz;
    if (responds(m)) {
        vec3 x = fetchCentre(m) + sim.substepTime * velocity;
        FieldSum fields = fieldsAt(x);
        vec3 wind = airVelocity(x) + fields.blown - velocity;
        vec4 turn = fetchRotation(m);
        vec3 drag = texelFetch(moverDrags, int(m)).xyz;
        acceleration += fields.acceleration + rotate(turn, dragAcceleration(rotate(conjugate(turn), wind), drag));
#ifdef CLOTH
        if (!IS_BODY(m)) acceleration += clothDrag(m, wind);
#endif
    }
    moverAccelerations[m] = vec4(acceleration, 0);
}
