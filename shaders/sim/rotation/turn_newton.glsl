// Newton's method from the last rotation on.

vec4 matchedTurn(mat3 a, vec4 start, vec4 turned)
{
    for (uint k = 0u; k < step.rotationIterations; ++k) turned = newtonTurn(a, start, turned);
    return turned;
}
