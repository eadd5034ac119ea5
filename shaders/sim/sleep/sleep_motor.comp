// One thread a motor: what it turns does not sleep, however slowly it turns.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/sleep/calm.glsl"
#include "shared/motor_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Motor, Motors, motors);
uniform usamplerBuffer jointFreedoms;
BUFFER(Calm, AssemblyNext, assemblyNext);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.motorCount) return;
    Motor motor = motors[k];
    if (motor.keepsAwake == 0u || texelFetch(jointFreedoms, int(motor.joint)).x == JOINT_NONE) return;
    assemblyNext[fetchMover(motor.body).assembly].steps = 0u;
}
