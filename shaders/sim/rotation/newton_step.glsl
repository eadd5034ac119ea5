// Newton's method on trace(R^T A) (the torque of Mueller et al. 2016, divided by the Hessian trace(S) I - S instead of
// by trace(S), so that long bodies converge about their axis too); Mueller's own step if the Hessian is not positive.
// Stores the rotation since the substep began, which keeps rounding errors small.

/// The divisor of a torque. @param s the symmetric part of A R^T.
mat3 rotationHessian(mat3 s)
{
    float trace = s[0][0] + s[1][1] + s[2][2];
    // A direction that no particle determines (a line's twist) keeps its rotation: eq. 18's purpose without its pull.
    mat3 hessian = mat3((1.0 + 1e-5) * trace) - s;
    float minor = hessian[0][0] * hessian[1][1] - hessian[0][1] * hessian[1][0];
    float size = abs(trace) + 1e-30;
    bool positive = hessian[0][0] > 0.0 && minor > 0.0 && determinant(hessian / size) > 1e-12;
    return positive ? hessian : mat3(size);
}

/// The symmetric part of A R^T.
mat3 stretchOf(mat3 a, mat3 r)
{
    mat3 g = a * transpose(r);
    return 0.5 * (g + transpose(g));
}

/// The rotation delta after one step.
vec4 newtonRotationDelta(mat3 a, vec4 start, vec4 delta)
{
    mat3 r = matrixFromQuaternion(quaternionProduct(delta, start));
    vec3 torque = cross(r[0], a[0]) + cross(r[1], a[1]) + cross(r[2], a[2]);
    mat3 hessian = rotationHessian(stretchOf(a, r));
    float size = hessian[0][0] + hessian[1][1] + hessian[2][2];
    vec3 further = inverse(hessian / size) * (torque / size);
    float angle = length(further);
    further *= min(1.0, 1.0 / max(angle, 1e-20));   // at most one radian
    return normalize(quaternionProduct(quaternionFromRotation(further), delta));
}
