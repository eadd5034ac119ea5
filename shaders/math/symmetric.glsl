// Symmetric matrices and their independent entries.

/// @param offDiagonal xy, xz, yz.
mat3 symmetricMatrix(vec3 diagonal, vec3 offDiagonal)
{
    return mat3(diagonal.x, offDiagonal.x, offDiagonal.y, offDiagonal.x, diagonal.y, offDiagonal.z, offDiagonal.y,
                offDiagonal.z, diagonal.z);
}

vec3 diagonalOf(mat3 m)
{
    return vec3(m[0][0], m[1][1], m[2][2]);
}

/// xy, xz, yz; means of both entries if rounding has made the matrix slightly asymmetric.
vec3 offDiagonalOf(mat3 m)
{
    return 0.5 * vec3(m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]);
}

float traceOf(mat3 m)
{
    return m[0][0] + m[1][1] + m[2][2];
}
