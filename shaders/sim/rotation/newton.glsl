// Newton's method, starting from the last rotation.

vec4 matchedRotationDelta(mat3 a, vec4 start, vec4 delta)
{
    for (uint k = 0u; k < sim.rotationIterations; ++k) delta = newtonRotationDelta(a, start, delta);
    return delta;
}
