// The load on a body that joints hold, where it is now: the residual of its shape match (eqs. 8-9), which the joints of
// its tree answer all at once. A body by itself would go where the residual is zero.
#include "math/quaternion.glsl"
#include "sim/common/bodies/body_loads.glsl"
#include "sim/rotation/newton_step.glsl"

/// Keeps a body that no torque can turn (a single particle's) regular [particle diameter squared times its mass].
#define LEAST_HESSIAN 1e-5

bool isPositive(mat3 m)
{
    float size = m[0][0] + m[1][1] + m[2][2];
    m /= size + 1e-30;
    return size > 0.0 && m[0][0] > 0.0 && m[0][0] * m[1][1] > m[0][1] * m[1][0] && determinant(m) > 0.0;
}

/// What impulses add to a body's A, with less of their compression the less the body could withstand it: a body turns
/// over if it is pressed between impulses that do not turn with it, but these do turn with it.
mat3 boundedCompression(mat3 impulses, mat3 rotation, mat3 moments)
{
    mat3 stretch = stretchOf(impulses, rotation);
    mat3 own = rotation * moments * transpose(rotation);
    own = 0.75 * (mat3((1.0 + 1e-5) * (own[0][0] + own[1][1] + own[2][2])) - own);
    mat3 added = mat3(stretch[0][0] + stretch[1][1] + stretch[2][2]) - stretch;
    float part = 1.0;
    for (int k = 0; k < 4 && !isPositive(own + part * added); ++k) part = k < 3 ? 0.5 * part : 0.0;
    return impulses - (1.0 - part) * stretch * rotation;
}

/// The prediction is relative to where the body is now: summed with its axes, which are of length 1, it would lose 6e-8
/// rad to rounding in each substep; in short ones that is an acceleration.
/// @param prediction its move if nothing held it, and what that adds to A. @param impulse on it. @param held the part
/// of its A from joints and ropes, which turn with what they hold: contacts do not count here as making it harder or
/// easier to turn, since they come and go. @param shift its move now. @param start its rotation when the substep began,
/// @param delta and how it has turned since. @param moments the sum of m r r^T.
/// substep began, @param delta and how it has turned since. @param moments the sum of m r r^T.
BodyLoad loadOf(Field prediction, Field impulse, mat3 held, vec3 shift, vec4 start, vec4 delta, float inverseMass,
                mat3 moments)
{
    mat3 turned = turnOfAxes(start, delta), r = matrixFromQuaternion(start) + turned;
    mat3 left = prediction.f - turned * moments, a = left + impulse.f;
    mat3 bounded = r * moments + left + boundedCompression(held, r, moments);
    vec3 torque = cross(r[0], a[0]) + cross(r[1], a[1]) + cross(r[2], a[2]);
    float least = LEAST_HESSIAN * sim.diameter * sim.diameter / inverseMass;
    mat3 hessian = rotationHessian(stretchOf(bounded, r)) + mat3(least);
    return BodyLoad((prediction.t - shift) / inverseMass + impulse.t, torque, hessian);
}
