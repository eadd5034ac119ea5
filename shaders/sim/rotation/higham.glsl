// Higham and Noferini 2016: the quaternion of the orthogonal part of A is the dominant eigenvector of a symmetric 4x4
// matrix K made of A. The adjugate of lambda I - K, with lambda just above the largest eigenvalue, takes any quaternion
// nearly there; it keeps what A does not determine (a line's twist). K is built anew around each quaternion found:
// there that is (0, 0, 0, 1), so only the adjugate's last column is needed, and small rotations have small rounding.

/// The columns of the adjugate of a symmetric m; for any other m, the rows.
mat3 adjugate(mat3 m)
{
    return mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
}

/// The largest eigenvalue of the K of an `a` of Frobenius norm 1: its characteristic polynomial is (lambda^2 - 1)^2 - 8
/// det(a) lambda - 4 |adj a|^2. Newton's method starts above it, and solves for u = lambda^2 - 1, which is small if a
/// body is nearly straight and lambda itself nearly a double root.
float largestEigenvalue(mat3 a)
{
    mat3 minors = adjugate(a);
    float c = dot(minors[0], minors[0]) + dot(minors[1], minors[1]) + dot(minors[2], minors[2]);
    float d = dot(a[0], minors[0]);
    // 1 / sqrt(3) <= lambda <= sqrt(3), and u >= -2 c.
    float u = 2.0 * sqrt(max(c + 2.0 * d * (d > 0.0 ? 1.7320508 : 0.57735027), 0.0));
    for (int k = 0; k < 6; ++k) {
        float lambda = sqrt(1.0 + u);
        float slope = 2.0 * u - 4.0 * d / lambda;
        if (slope > 0.0) u = max(u - (u * u - 4.0 * c - 8.0 * d * lambda) / slope, -2.0 * c);
    }
    return sqrt(1.0 + u);
}

vec4 matchedRotationDelta(mat3 a, vec4 start, vec4 delta)
{
    float size = sqrt(dot(a[0], a[0]) + dot(a[1], a[1]) + dot(a[2], a[2]));
    a /= max(size, 1e-18);
    // The offset is far larger than rounding, so that rounding twists no line; each round leaves of the remaining error
    // this fraction of lambda, over the distance to the next eigenvalue.
    float lambda = (1.0 + 1e-4) * largestEigenvalue(a);
    for (int k = 0; k < 3; ++k) {
        mat3 b = a * transpose(matrixFromQuaternion(quaternionProduct(delta, start)));
        float trace = b[0][0] + b[1][1] + b[2][2];
        vec3 torque = vec3(b[1][2] - b[2][1], b[2][0] - b[0][2], b[0][1] - b[1][0]);
        mat3 p = mat3(lambda + trace) - b - transpose(b);   // lambda I - K without its last row and column
        mat3 minors = adjugate(p);
        vec4 further = vec4(minors * torque, dot(p[0], minors[0]));
        float square = dot(further, further);
        if (square > 1e-30) delta = normalize(quaternionProduct(further * inversesqrt(square), delta));
    }
    return delta;
}
