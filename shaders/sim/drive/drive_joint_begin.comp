// One thread a driven joint, where a substep begins: how far it is from its clip, and how much that has changed in the
// substep before.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/drive/drive_states.glsl"
#include "sim/drive/turns.glsl"
#include "shared/animation_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(GpuJointDrive, JointDrives, jointDrives);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform samplerBuffer clipBodyTurns;
BUFFER(vec4, DriveStates, driveStates);

void main()
{
    uint j = gl_GlobalInvocationID.x;
    if (j >= sim.jointDriveCount) return;
    GpuJointDrive drive = jointDrives[j];
    AnimatedBody at = animatedBodies[drive.body];
    uint state = DRIVE_STATE_TEXELS * j;
    vec4 parent = fetchRotation(animatedBodies[at.parent].mover);
    vec4 began = turnFrom(driveStates[state + DRIVE_TARGET], parent, fetchRotation(at.mover));
    driveStates[state + DRIVE_CHANGE].xyz = turnBetween(driveStates[state + DRIVE_TURN], began);
    driveStates[state + DRIVE_TURN] = began;
    driveStates[state + DRIVE_TARGET] = texelFetch(clipBodyTurns, int(drive.body));
}
