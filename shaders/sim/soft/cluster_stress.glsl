// Elastic stress of a cluster of a soft body, by the linear map F nearest to its particles' places.

float trace(mat3 m)
{
    return m[0][0] + m[1][1] + m[2][2];
}

float squaredNorm(mat3 m)
{
    return dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]);
}

/// Hooke's law: twice the shear modulus and Lame's lambda, over the density.
mat3 hooke(SoftMatter matter, mat3 strain)
{
    return matter.shear * strain + mat3(matter.dilation * trace(strain));
}

/// Not less than any stretch of a map, squared (Gershgorin's circles).
float largestStretch(mat3 squares)
{
    mat3 sizes = mat3(abs(squares[0]), abs(squares[1]), abs(squares[2]));
    vec3 rows = sizes * vec3(1);
    return max(rows.x, max(rows.y, rows.z));
}

/// Viscous stress times the substep, in the axes at rest: of Green's strain, which rotations do not change. It does not
/// grow with the cluster's stretch, so that it stays stable.
mat3 viscousStress(SoftMatter matter, mat3 map, mat3 mapBefore)
{
    mat3 squares = transpose(map) * map, change = 0.5 * (squares - transpose(mapBefore) * mapBefore);
    return (matter.damping / max(1.0, largestStretch(squares))) * hooke(matter, change);
}

/// The map by which a cluster has flowed after a substep, from the one before (Mueller et al. 2005, section 4.3): by a
/// fraction of the strain beyond `yield`, at constant volume.
mat3 flowed(SoftMatter matter, mat3 rest, mat3 strain)
{
    float size = sqrt(squaredNorm(strain));
    float fraction = (1.0 - exp(-matter.creep * sim.substepTime)) * max(1.0 - matter.yield / max(size, 1e-20), 0.0);
    mat3 next = rest + fraction * strain * rest;
    next *= pow(max(determinant(next), 1e-6), -1.0 / 3.0);
    mat3 change = next - mat3(1);
    return mat3(1) + min(1.0, matter.maxDeformation / max(sqrt(squaredNorm(change)), 1e-20)) * change;
}
