// One thread a body: the paper's polar decomposition (eqs. 11-17): Q = A M^(-1/2), M = A^T A = E lambda E^T by the QR
// algorithm with Householder reflections. Flat and straight bodies get virtual particles (eq. 18), scaled by A and only
// where A is rank deficient: taken everywhere they would brake every rotation.
#include "shared/kernel.glsl"
#include "shared/quaternion.glsl"

#define QR_ITERATIONS 24

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer bodyMatrices;
uniform samplerBuffer bodyStarts;
uniform samplerBuffer bodyMoves;
BUFFER(vec4, BodyCentres, bodyCentres);
BUFFER(vec4, BodyTurns, bodyTurns);
BUFFER(vec4, BodyRotations, bodyRotations);

/// The reflection I - 2 v v^T / v^T v that zeroes m's column `k` below the diagonal.
mat3 householder(mat3 m, int k)
{
    vec3 v = m[k];
    for (int row = 0; row < k; ++row) v[row] = 0.0;
    float size = length(v);
    v[k] += v[k] < 0.0 ? -size : size;
    float square = dot(v, v);
    return square > 1e-30 ? mat3(1) - (2.0 / square) * outerProduct(v, v) : mat3(1);
}

/// m = E lambda E^T for a symmetric m. @returns E; m becomes diagonal.
mat3 eigenvectors(inout mat3 m)
{
    mat3 e = mat3(1);
    for (int k = 0; k < QR_ITERATIONS; ++k) {
        mat3 first = householder(m, 0);
        mat3 second = householder(first * m, 1);
        mat3 q = first * second;              // m = q r, and r q is similar to m
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

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= step.bodyCount) return;
    bodyCentres[b] = texelFetch(bodyStarts, int(2u * b)) + texelFetch(bodyMoves, int(b));
    mat3 a;
    for (int column = 0; column < 3; ++column) a[column] = texelFetch(bodyMatrices, int(3u * b) + column).xyz;
    float rank;
    mat3 q = orthogonalPart(a, rank);
    if (rank < 1e-5 && step.virtualParticles > 0.0) {
        float size = sqrt(dot(a[0], a[0]) + dot(a[1], a[1]) + dot(a[2], a[2]));
        a += step.virtualParticles * size * matrixFromQuaternion(bodyRotations[b]);
        q = orthogonalPart(a, rank);
    }
    // A mirrored or collapsed body keeps its last rotation.
    if (determinant(q) > 0.5) bodyRotations[b] = quaternionFromMatrix(q);
    bodyTurns[b] = quaternionProduct(bodyRotations[b], conjugate(texelFetch(bodyStarts, int(2u * b + 1u))));
}
