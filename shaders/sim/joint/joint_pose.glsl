// Where each of a joint's two bodies has the joint, and how far these places are apart.
#include "sim/common/bodies/movers.glsl"
#include "sim/joint/joint_info.glsl"
#include "math/spatial.glsl"

/// A joint as one of its bodies has it.
struct JointSide {
    MoverPoint point;
    vec3 arm;         // from the centre to the joint, now [m]
    vec4 startFrame;  // axes of the joint at the start of the substep
    vec4 frame;       // and now
};

JointSide jointSide(uint joint, uint side, uint body)
{
    JointPlace place = fetchJointPlace(joint, side);
    JointSide s;
    s.point = moverPoint(body, place.arm);
    s.arm = s.point.arm + (s.point.move - fetchMove(body).shift);
    s.startFrame = quaternionProduct(fetchRotation(body), place.frame);
    s.frame = quaternionProduct(fetchRotationDelta(body), s.startFrame);
    return s;
}

/// The turn from one frame to another that a joint forbids.
vec3 turnBetween(vec4 from, vec4 to, uint freedom)
{
    if (freedom == JOINT_BALL) return vec3(0);
    if (freedom == JOINT_HINGE) return cross(rotate(from, vec3(1, 0, 0)), rotate(to, vec3(1, 0, 0)));
    vec4 turn = quaternionProduct(to, conjugate(from));
    return (turn.w < 0.0 ? -2.0 : 2.0) * turn.xyz;
}

/// How far the body has left its parent at the joint: at the start of the substep ...
Motion startError(JointSide body, JointSide parent, uint freedom)
{
    return Motion(body.point.centre - parent.point.centre + (body.point.arm - parent.point.arm),
                  turnBetween(parent.startFrame, body.startFrame, freedom));
}

/// ... and now.
Motion errorNow(JointSide body, JointSide parent, uint freedom)
{
    vec3 start = body.point.centre - parent.point.centre + (body.point.arm - parent.point.arm);
    return Motion(start + (body.point.move - parent.point.move), turnBetween(parent.frame, body.frame, freedom));
}
