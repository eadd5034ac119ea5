// L D L^T of symmetric positive matrices: solving by it leaves a residual as small as rounding, even if the matrix is
// much harder in one direction than in another (Golub and Van Loan, Matrix Computations, 4.1). An inverse does not.

struct Cholesky {
    vec3 inversePivots;
    vec3 lower;           // of L: yx, zx, zy
};

Cholesky choleskyOf(mat3 m)
{
    float yx = m[0][1] / m[0][0], zx = m[0][2] / m[0][0];
    float y = m[1][1] - yx * m[0][1], zy = (m[1][2] - zx * m[0][1]) / y;
    float z = m[2][2] - zx * m[0][2] - zy * zy * y;
    return Cholesky(1.0 / vec3(m[0][0], y, z), vec3(yx, zx, zy));
}

/// L^-1 v.
vec3 forward(Cholesky c, vec3 v)
{
    v.y -= c.lower.x * v.x;
    v.z -= c.lower.y * v.x + c.lower.z * v.y;
    return v;
}

vec3 solve(Cholesky c, vec3 v)
{
    v = forward(c, v) * c.inversePivots;
    v.y -= c.lower.z * v.z;
    v.x -= c.lower.x * v.y + c.lower.y * v.z;
    return v;
}

mat3 solve(Cholesky c, mat3 m)
{
    return mat3(solve(c, m[0]), solve(c, m[1]), solve(c, m[2]));
}
