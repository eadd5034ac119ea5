// One thread a tree of joints: from the leaves to the root, each joint passes on the inertia of its body, with all that
// hangs on it, except for the motions that it leaves free (Featherstone 2008, articulated bodies). Runs once a substep;
// joint_solve uses it. RESPONSES: of a world where something needs to know how bodies answer to forces. LIMITS: of one
// where joints are limited. DRIVES: where they are driven. AGAIN: later in a substep, where bodies have turned since
// their elimination, or other springs hold than before. LAST: in the last of several iterations.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/body_loads.glsl"
#include "sim/joint/joint_elimination.glsl"
#include "sim/joint/joint_pose.glsl"
#include "sim/joint/joint_recovery.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
#ifdef LIMITS
#include "sim/joint/limits/joint_limit_update.glsl"
#endif
#ifdef DRIVES
#include "sim/joint/joint_drives.glsl"
#endif
BUFFER(vec4, JointFactors, jointFactors);
BUFFER(vec4, RootFactors, rootFactors);
#include "sim/joint/joint_inertias.glsl"
#ifdef AGAIN
#include "sim/joint/joint_again.glsl"
#endif

/// A body that does not respond holds what hangs on it.
void factor(uint k)
{
    Joint joint = fetchJoint(k);
    uint freedom = fetchFreedom(k);
    bool free = responds(joint.body);
    Inertia m = Inertia(mat3(moverMass(joint.body)), mat3(0), fetchBodyLoad(joint.body).hessian);
    m = withHanded(k, joint, m);
#ifdef DRIVES
    m = add(m, pinStiffness(k));
#endif
#ifdef AGAIN
    if (free) m.d += mat3(turnDamping(k, m.a, length(loadMotion(k, SWEEP_MOTION).r)));
#endif
    Inertia passed = Inertia(mat3(0), mat3(0), mat3(0));
    if (free && freedom == JOINT_NONE) {
        FactoredInertia root = factored(m);
        STORE_ROOT_FACTOR(rootFactors, k, root)
    }
    if (free && freedom != JOINT_NONE) {
        JointSide body = jointSide(k, 0u, joint.body), parent = jointSide(k, 1u, joint.parent);
        Motion kept = keptOf(startError(body, parent, freedom));
        JointFactor f = JointFactor(shifted(m, body.arm), Cholesky(vec3(0), vec3(0)), body.arm, parent.arm,
                                    rotate(body.frame, vec3(1, 0, 0)), kept);
        mat3 stops = mat3(0);
#ifdef LIMITS
        stops = limitStiffness(k, f.inertia);
#endif
#ifdef DRIVES
        stops += drivenStiffness(k);
#endif
        passed = shifted(handedOnBy(f, freedom, stops), -parent.arm);
        STORE_JOINT_FACTOR(jointFactors, k, f)
    }
    storeInertia(k, passed);
}

#ifdef RESPONSES
#include "sim/joint/joint_responses.glsl"
#endif

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (index >= sim.jointTreeCount) return;
    JointTree tree = fetchJointTree(index);
    if (treeRests(tree)) return;
    bool due = true;
#ifdef AGAIN
    due = hasTurned(index);
#ifdef DRIVES
    due = drivesChanged(tree) || due;
#endif
#ifdef LIMITS
    due = updateLimits(tree) || due;
#endif
#elif defined(LIMITS)
    updateLimits(tree);
#endif
    if (!due) return;
    UP_TREE(tree, factor(k))
#ifdef RESPONSES
    for (uint k = tree.first; k < tree.end; ++k) respond(k);
#endif
}
