// Newton's method from the last rotation on.

vec4 matchedRotationDelta(mat3 a, vec4 start, vec4 turned)
{
    for (uint k = 0u; k < sim.rotationIterations; ++k) turned = newtonRotationDelta(a, start, turned);
    return turned;
}
