// State of a driven object, in two texels of puppetStates: phase, the substep in which that began, whether it is
// knocked out; bits of where its clips are put after it was caught.
#include "shared/drive_types.h"

struct PuppetState {
    uint phase;     // PUPPET_*
    uint since;
    uint knocked;
    vec3 shift;     // of its clips in the world [m] ...
    float yaw;      // ... after a turn about y [rad]
};

#define PUPPET_STATE_FROM(a, b) \
    PuppetState((a).x, (a).y, (a).z, uintBitsToFloat((b).xyz), uintBitsToFloat((b).w))

/// @param states declared as BUFFER(uvec4, ...).
#define STORE_PUPPET_STATE(states, puppet, s) \
    states[2u * (puppet)] = uvec4((s).phase, (s).since, (s).knocked, 0u); \
    states[2u * (puppet) + 1u] = uvec4(floatBitsToUint((s).shift), floatBitsToUint((s).yaw));

/// The part of a duration [s] that has passed since a puppet's phase began, eased at both ends: 0 ... 1.
float easedPart(PuppetState s, uint substep, float duration)
{
    return smoothstep(0.0, max(duration, 1e-6), float(substep - s.since) * sim.substepTime);
}
