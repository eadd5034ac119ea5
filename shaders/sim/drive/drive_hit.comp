// One thread a body of a puppet, at the end of a substep: a blow reduces its strength, which gradually comes back. A
// push of less than three times the whole puppet's weight is no blow.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "shared/animation_types.h"
#include "shared/drive_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Puppet, Puppets, puppets);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
READ_BUFFER(Animation, Animations, animations);
uniform samplerBuffer bodyPushes;
BUFFER(vec4, DriveHits, driveHits);      // strength taken, 0 ... 1; time since the last blow [s]

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.animatedCount) return;
    uint p = animations[animatedBodies[k].animation].puppet, m = animatedBodies[k].mover;
    if (p == NONE || !responds(m)) return;
    Puppet puppet = puppets[p];
    float impulse = length(fetchField(bodyPushes, m).t) / sim.substepTime;
    float blow = (impulse - 3.0 * puppet.mass * length(sim.gravity.xyz) * sim.substepTime) / puppet.hitImpulse;
    float taken = driveHits[k].x, since = driveHits[k].y + sim.substepTime;
    if (blow > 0.0) {
        taken = min(1.0, taken + blow);
        since = 0.0;
    } else if (since > puppet.hitHold) {
        taken = max(0.0, taken - sim.substepTime / puppet.hitRecover);
    }
    driveHits[k].xy = vec2(taken, since);
}
