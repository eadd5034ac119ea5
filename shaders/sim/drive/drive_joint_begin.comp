// One thread a driven joint, at the start of a substep: its distance from its clip, the change of that in the substep
// before, and whether it has been at its greatest torque for too long.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/drive/drive_states.glsl"
#include "sim/drive/turns.glsl"
#include "shared/animation_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(JointDrive, JointDrives, jointDrives);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform samplerBuffer clipBodyTurns;
BUFFER(vec4, DriveStates, driveStates);
READ_BUFFER(Puppet, Puppets, puppets);
BUFFER(uvec4, PuppetStates, newPuppetStates);

void main()
{
    uint j = gl_GlobalInvocationID.x;
    if (j >= sim.jointDriveCount) return;
    JointDrive drive = jointDrives[j];
    AnimatedBody at = animatedBodies[drive.body];
    uint state = DRIVE_STATE_TEXELS * j;
    vec4 parent = fetchRotation(animatedBodies[at.parent].mover);
    vec4 began = turnFrom(driveStates[state + DRIVE_TARGET], parent, fetchRotation(at.mover));
    driveStates[state + DRIVE_CHANGE].xyz = turnBetween(driveStates[state + DRIVE_TURN], began);
    driveStates[state + DRIVE_TURN] = began;
    bool bounded = driveStates[state + DRIVE_CHANGE].w < 1.0;
    float held = bounded ? driveStates[state + DRIVE_HELD].x + sim.substepTime : 0.0;
    driveStates[state + DRIVE_HELD].x = held;
    // Other threads that write here write the same value.
    if (held > puppets[drive.puppet].knockTime) newPuppetStates[2u * drive.puppet].z = 1u;
    driveStates[state + DRIVE_TARGET] = texelFetch(clipBodyTurns, int(drive.body));
}
