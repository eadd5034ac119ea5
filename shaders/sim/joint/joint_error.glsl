// The error that a solve corrects: how far a joint is open, less what the substep keeps of it. And bodies' moves.
#include "sim/joint/joint_pose.glsl"

BUFFER(vec4, MoverMoves, newMoverMoves);
BUFFER(vec4, MoverRotationDeltas, newMoverRotationDeltas);

Motion errorBeyond(uint k, Motion kept)
{
    Joint joint = fetchJoint(k);
    Motion error = errorNow(jointSide(k, 0u, joint.body), jointSide(k, 1u, joint.parent), fetchFreedom(k));
    return Motion(error.t - kept.t, error.r - kept.r);
}

void moveBody(uint body, Motion m)
{
    if (!responds(body)) return;
    newMoverMoves[body].xyz = fetchMove(body).shift + m.t;
    vec4 turned = quaternionProduct(quaternionFromSmallRotation(m.r), fetchRotationDelta(body));
    newMoverRotationDeltas[body] = normalize(turned);
}
