// One thread a train of gears, after joint_solve: corrects the torques of its hinges so that, once gear_move has
// answered them, each is turned by its ratio times as far as the train's first. The gears do no work, so the torques T
// and ratios r of what hangs together satisfy sum r T = 0. BEGIN: only turns the torques with the axes, at the start of
// a substep.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/joint/joint_factors.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/gears/gear_states.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(uvec2, GearTrains, gearTrains);   // first hinge, end
uniform samplerBuffer jointFactors;
BUFFER(vec4, RowAngularImpulses, newRowAngularImpulses);
BUFFER(float, GearAsked, gearAsked);

/// How far a torque turns a hinge, 0 for one that is torn: as its tree answers while the parent stands still, and by
/// what the parent alone gives way, twice, since two hinges of one parent turn it with both torques.
float givesWay(uint k, Joint joint, vec3 axis)
{
    if (fetchFreedom(k) == JOINT_NONE) return 0.0;
#define TEXEL(n) texelFetch(jointFactors, int(JOINT_FACTOR_TEXELS * k) + n)
    JointFactor factor = JOINT_FACTOR_FROM(TEXEL);
#undef TEXEL
    float way = responds(joint.body) ? factor.free.inversePivots.x : 0.0;
    if (joint.parent == NONE || !responds(joint.parent)) return way;
    InverseInertia alone = fetchInverseInertia(joint.parent);
    vec3 own = rotate(conjugate(fetchRotation(joint.parent)), axis);
    return way + 2.0 * dot(own, symmetricMatrix(alone.diagonal, alone.offDiagonal) * own);
}

/// Notes how far a hinge is off, and adds it to what hangs together.
void look(uint h)
{
    GearedHinge hinge = gearHinges[h];
    Joint joint = fetchJoint(hinge.joint);
    vec4 body = jointSide(hinge.joint, 0u, joint.body).frame, parent = jointSide(hinge.joint, 1u, joint.parent).frame;
    GearState s = loadGearState(h);
    float angle = angleAboutX(quaternionProduct(conjugate(parent), body), s.angle);
    s.off += angle - s.angle;
    s.angle = angleAboutX(quaternionProduct(conjugate(parent), body), 0.0);
    s.way = givesWay(hinge.joint, joint, rotate(body, vec3(1, 0, 0)));
    if (s.way == 0.0) s.torque = 0.0;
    storeGearState(h, s);
    uint head = headOf(h);
    storeHead(h, head);
    GearSums sums = head == h ? GearSums(0, 0, 0) : loadGearSums(head);
    if (sums.ways < 0.0) return;
    if (s.way > 0.0) {
        sums.off += hinge.ratio * s.off / s.way;
        sums.torque += hinge.ratio * s.torque;
        sums.ways += hinge.ratio * hinge.ratio / s.way;
    } else {
        // What answers to nothing leads all others.
        sums = GearSums(-s.off / hinge.ratio, 0, -1);
    }
    storeGearSums(head, sums);
}

/// @param squaredTime of a torque [s2].
void correct(uint h, float squaredTime)
{
    float ratio = gearHinges[h].ratio;
    GearState s = loadGearState(h);
    GearSums sums = loadGearSums(loadHead(h));
    s.off -= ratio * sums.off / sums.ways;
    float before = s.torque;
    if (s.way > 0.0) {
        s.torque -= s.off / (s.way * squaredTime);
        if (sums.ways > 0.0) s.torque -= ratio / s.way * sums.torque / sums.ways;
    }
    storeGearState(h, s);
    gearAsked[h] = squaredTime * (s.torque - before);
}

void push(uint h, float squaredTime)
{
    GearedHinge hinge = gearHinges[h];
    vec3 axis = rotate(jointSide(hinge.joint, 0u, fetchJoint(hinge.joint).body).frame, vec3(1, 0, 0));
    vec3 torque = squaredTime * loadGearState(h).torque * axis;
    newRowAngularImpulses[hinge.row].xyz = torque;
    if (hinge.parentRow != NONE) newRowAngularImpulses[hinge.parentRow].xyz = -torque;
}

void main()
{
    uint train = gl_GlobalInvocationID.x;
    if (train >= sim.gearTrainCount) return;
    uvec2 range = gearTrains[train];
    Assembly assembly = fetchAssembly(fetchMover(fetchJoint(gearHinges[range.x].joint).body).assembly);
    float squaredTime = accelerationFactor(assembly) * sim.substepTime * sim.substepTime;
#ifndef BEGIN
    for (uint h = range.x; h < range.y; ++h) look(h);
    for (uint h = range.x; h < range.y; ++h) correct(h, squaredTime);
#endif
    for (uint h = range.x; h < range.y; ++h) push(h, squaredTime);
}
