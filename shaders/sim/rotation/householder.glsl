// The paper's polar decomposition (eqs. 11-17): Q = A M^(-1/2), M = A^T A = E lambda E^T by the QR algorithm with
// Householder reflections. Flat and straight bodies get virtual particles (eq. 18), scaled by A and only if A is rank
// deficient: elsewhere they would brake every rotation. M squares the rounding of A, so a step of Newton's method
// follows: otherwise the error would keep a pendulum swinging.

#define QR_ITERATIONS 24

/// The reflection I - 2 v v^T / v^T v that zeroes column `k` of m below the diagonal.
mat3 householder(mat3 m, int k)
{
    vec3 v = m[k];
    for (int row = 0; row < k; ++row) v[row] = 0.0;
    float size = length(v);
    v[k] += v[k] < 0.0 ? -size : size;
    float square = dot(v, v);
    return square > 1e-30 ? mat3(1) - (2.0 / square) * outerProduct(v, v) : mat3(1);
}

/// The eigenvalue of the 2x2 block ending at `k` that is nearer to its last element (Wilkinson's shift): with it a few
/// iterations suffice; without it close eigenvalues would take hundreds.
float shift(mat3 m, int k)
{
    float d = 0.5 * (m[k - 1][k - 1] - m[k][k]), b = m[k][k - 1];
    float size = abs(d) + sqrt(d * d + b * b);
    return size > 0.0 ? m[k][k] - (d < 0.0 ? -1.0 : 1.0) * b * b / size : m[k][k];
}

/// m = E lambda E^T for a symmetric m. @returns E; m becomes diagonal.
mat3 eigenvectors(inout mat3 m)
{
    mat3 e = mat3(1);
    for (int k = 0; k < QR_ITERATIONS; ++k) {
        bool whole = abs(m[2][0]) + abs(m[2][1]) > 1e-7;   // else only the block before the last row is left
        mat3 s = m - mat3(shift(m, whole ? 2 : 1));
        mat3 first = householder(s, 0);
        mat3 second = householder(first * s, 1);
        mat3 q = first * second;              // s = q r, and r q is similar to s
        m = transpose(q) * m * q;
        e = e * q;
    }
    return e;
}

mat3 orthogonalPart(mat3 a, out float rank)
{
    mat3 m = transpose(a) * a;
    float size = max(m[0][0] + m[1][1] + m[2][2], 1e-30);
    m /= size;
    mat3 e = eigenvectors(m);
    vec3 lambda = max(vec3(m[0][0], m[1][1], m[2][2]), vec3(0));
    float largest = max(lambda.x, max(lambda.y, lambda.z));
    float least = min(lambda.x, min(lambda.y, lambda.z));
    rank = least / largest;
    vec3 root = inversesqrt(max(lambda, vec3(1e-12 * largest)) * size);
    return a * e * mat3(root.x, 0, 0, 0, root.y, 0, 0, 0, root.z) * transpose(e);
}

vec4 matchedRotationDelta(mat3 a, vec4 start, vec4 delta)
{
    float rank;
    mat3 q = orthogonalPart(a, rank);
    if (rank < 1e-5 && sim.virtualParticles > 0.0) {
        float size = sqrt(dot(a[0], a[0]) + dot(a[1], a[1]) + dot(a[2], a[2]));
        a += sim.virtualParticles * size * matrixFromQuaternion(quaternionProduct(delta, start));
        q = orthogonalPart(a, rank);
    }
    // A mirrored or collapsed body keeps its last rotation.
    if (determinant(q) <= 0.5) return delta;
    return newtonRotationDelta(a, start, quaternionProduct(quaternionFromMatrix(q), conjugate(start)));
}
