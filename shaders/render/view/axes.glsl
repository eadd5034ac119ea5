// A horizontal unit vector to the right of a viewer who looks against `direction`.
vec3 perpendicular(vec3 direction)
{
    vec3 side = cross(abs(direction.y) > 0.999 ? vec3(0.0, 0.0, -1.0) : vec3(0.0, 1.0, 0.0), direction);
    return normalize(side);
}

void turn(inout vec3 a, inout vec3 b, float angle)
{
    if (angle == 0.0) return;
    vec3 turned = cos(angle) * a + sin(angle) * b;
    b = cos(angle) * b - sin(angle) * a;
    a = turned;
}
