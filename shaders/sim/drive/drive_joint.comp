// One thread a driven joint: the torque between its bodies, from where they are now, and what it adds to the joint's
// block. All in the parent's axes as E: the turn by which the body differs from its clip, and as c: by how much that
// has changed in the substep, which is its velocity less the clip's. BEGIN: where a substep begins.
#include "sim/common/kernel.glsl"
#include "sim/drive/drive_spring.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(GpuJointDrive, JointDrives, jointDrives);
uniform usamplerBuffer jointFreedoms;
uniform samplerBuffer clipBodyTurns;
BUFFER(vec4, DriveStates, driveStates);
BUFFER(vec4, DriveStiffness, driveStiffness);
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);

#define STATE_TURN 0u      // E, when the substep began
#define STATE_TARGET 1u    // the clip at its end
#define STATE_CHANGE 2u    // c of the substep before; w: the part of its torque that its greatest one left

/// E of two rotations.
vec4 turnFrom(vec4 target, vec4 parent, vec4 body)
{
    return quaternionProduct(quaternionProduct(conjugate(parent), body), conjugate(target));
}

/// What the spring adds about the free axes, in the axes of the world [kg m2].
mat3 springInertia(GpuJointDrive drive, vec4 rotation, out vec3 axis)
{
    mat3 inertia = inertiaNow(drive.inertia, drive.inertiaBeside, rotation);
    axis = rotate(rotation, drive.axis.xyz);
    return drive.inertiaBeside.w == 0.0 ? inertia : dot(axis, inertia * axis) * outerProduct(axis, axis);
}

void storeTorque(GpuJointDrive drive, vec3 torque, mat3 block)
{
    uint first = DRIVE_STIFFNESS_TEXELS * drive.joint;
    vec3 diagonal = diagonalOf(block);
#ifdef BEGIN
    float stale = 0.0;
#else
    float stale = isStale(driveStiffness[first].xyz, diagonal);
    newRowAngularImpulses[drive.row].xyz = torque;
    newRowAngularImpulses[drive.parentRow].xyz = -torque;
#endif
    driveStiffness[first] = vec4(diagonal, stale);
    driveStiffness[first + 1u].xyz = offDiagonalOf(block);
}

void main()
{
    uint j = gl_GlobalInvocationID.x;
    if (j >= sim.jointDriveCount) return;
    GpuJointDrive drive = jointDrives[j];
    AnimatedBody at = animatedBodies[drive.body];
    uint body = at.mover, parent = animatedBodies[at.parent].mover, state = DRIVE_STATE_TEXELS * j;
#ifdef BEGIN
    vec4 began = turnFrom(driveStates[state + STATE_TARGET], fetchRotation(parent), fetchRotation(body));
    vec3 last = turnOfQuaternion(quaternionProduct(began, conjugate(driveStates[state + STATE_TURN])));
    driveStates[state + STATE_TURN] = began;
    driveStates[state + STATE_TARGET] = texelFetch(clipBodyTurns, int(drive.body));
    driveStates[state + STATE_CHANGE].xyz = last;
#endif
    float level = texelFetch(driveLevels, int(drive.body)).x;
    if (level == 0.0 || !responds(body) || texelFetch(jointFreedoms, int(drive.joint)).x == JOINT_NONE) {
        storeTorque(drive, vec3(0), mat3(0));
        return;
    }
    Assembly assembly = fetchAssembly(fetchMover(body).assembly);
    bool second = assembly.order == 2u;
    float squaredTime = accelerationFactor(assembly) * sim.substepTime * sim.substepTime;
    float stiffness = level * drive.stiffness, damping = sqrt(level) * drive.damping;
    vec4 change = driveStates[state + STATE_CHANGE];
    vec4 rotation = turnedNow(body);
    vec3 axis;
    mat3 inertia = springInertia(drive, rotation, axis);
#ifndef BEGIN
    vec4 parentNow = turnedNow(parent), from = turnFrom(driveStates[state + STATE_TARGET], parentNow, rotation);
    vec3 turned = turnOfQuaternion(quaternionProduct(from, conjugate(driveStates[state + STATE_TURN])));
    vec3 rate = rateOf(turned, change.xyz, second) / sim.substepTime;
    vec3 torque = -inertia * rotate(parentNow, stiffness * turnOfQuaternion(from) + damping * rate);
    change.w = boundedPart(length(torque), level * drive.inertia.w);
    driveStates[state + STATE_CHANGE].w = change.w;
    torque *= squaredTime * change.w;
#else
    vec3 torque = vec3(0);
#endif
    storeTorque(drive, torque, squaredTime * change.w * implicitPart(stiffness, damping, second) * inertia);
}
