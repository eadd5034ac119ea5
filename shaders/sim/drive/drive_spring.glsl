// A spring and a damper between something and its clip, at their places at the end of the substep.
#include "sim/drive/drive_states.glsl"
#include "sim/drive/spring_time.glsl"
#include "shared/animation_types.h"

READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform samplerBuffer driveLevels;
uniform samplerBuffer driveInertias;

/// The inertia that an animated body's drive or its pin turns [kg m2].
mat3 fetchInertia(uint body, uint pin)
{
    int first = int(4u * body + 2u * pin);
    return symmetricMatrix(texelFetch(driveInertias, first).xyz, texelFetch(driveInertias, first + 1).xyz);
}
