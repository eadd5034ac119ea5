// One thread a tree of joints: computes the impulses of all its joints at once, and moves its bodies by them: a Newton
// step of their positions (Deul et al. 2018). LOOPS: of a world where joints close loops; joint_loop_solve then moves
// the bodies. LIMITS: where joints are limited. FIRST: of a substep. TURNS: where trees may be eliminated again, and
// may take only a part of their answer.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/body_loads.glsl"
#include "sim/joint/joint_error.glsl"
#include "sim/joint/joint_rows.glsl"
#include "sim/joint/joint_sweeps.glsl"
#ifdef LIMITS
#include "sim/joint/limits/joint_limit_solve.glsl"
#endif

layout(local_size_x = TREE_GROUP_SIZE) in;
#ifdef TURNS
#include "sim/joint/joint_step.glsl"
#endif

/// As a hinge's body turns, the hinge's remembered torque gets a part about the hinge itself, which would drive the
/// joint. @returns the torque that cancels this part.
vec3 strayTorque(uint k)
{
    vec3 stray = vec3(0);
#if defined(ANGULAR) && defined(FIRST)
    if (fetchFreedom(k) == JOINT_HINGE) {
        vec3 held = ROW(RowAngularImpulses, fetchJoint(k).row), axis = fetchJointFactor(k).axis;
#ifdef LIMITS
        held -= oldLimitTorque(k);
#endif
        stray = -axis * dot(axis, held);
    }
#endif
    return stray;
}

/// Passes on the load of a body and its joint.
void ask(uint k)
{
    Joint joint = fetchJoint(k);
    BodyLoad load = fetchBodyLoad(joint.body);
    Motion error = Motion(vec3(0), vec3(0));
    vec3 stop = vec3(0);
    if (fetchFreedom(k) != JOINT_NONE && responds(joint.body)) {
        error = errorBeyond(k, fetchJointKept(k));
#ifdef LIMITS
        stop = limitTorque(k);
#endif
        stop += strayTorque(k);
    }
    passForce(k, Force(load.force, load.torque), error, stop);
}

/// @param part of the answer that the tree takes.
void take(uint k, Answer answer, float part)
{
    Force held = scaled(answer.held, part);
    Motion motion = scaled(answer.motion, part);
    held.r += strayTorque(k);
#ifdef LIMITS
    held.r += limitTorqueOf(k, answer, part);
#endif
    pushBoth(k, held);
#ifdef LOOPS
    storeMotion(k, SWEEP_TOTAL, motion);
#else
    moveBody(fetchJoint(k).body, motion);
#endif
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
    UP_TREE(tree, ask(k))
#ifdef TURNS
    float part = partToTake(index, tree);
    DOWN_TREE(tree, take(k, loadAnswer(k), part))
#else
    DOWN_TREE(tree, take(k, follow(k), 1.0))
#endif
}
