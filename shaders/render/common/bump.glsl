// Normals of a surface with bumps.

/// The normal where a surface at `place` has a height over it, whose changes from pixel to pixel are given in the unit
/// of `place` (Mikkelsen 2010); of any length.
vec3 bumped(vec3 normal, vec3 place, vec2 rise)
{
    vec3 acrossX = dFdx(place), acrossY = dFdy(place);
    vec3 first = cross(acrossY, normal), second = cross(normal, acrossX);
    float size = dot(acrossX, first);
    return abs(size) * normal - sign(size) * (rise.x * first + rise.y * second);
}
