// A horizontal unit vector to the right of a viewer who looks against `direction`.
vec3 perpendicular(vec3 direction)
{
    vec3 side = cross(abs(direction.y) > 0.999 ? vec3(0.0, 0.0, -1.0) : vec3(0.0, 1.0, 0.0), direction);
    return normalize(side);
}
