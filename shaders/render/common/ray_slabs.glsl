// Where a ray enters and leaves a box about the origin, by its three slabs (Kay and Kajiya 1986).

struct Slabs {
    vec3 near, far;     // parametric distances of both planes across each axis
    float enter, leave;
};

bool isMet(Slabs slabs)
{
    return slabs.enter < slabs.leave && slabs.leave > 0.0;
}

Slabs raySlabs(vec3 origin, vec3 direction, vec3 halfExtents)
{
    vec3 inverse = 1.0 / mix(direction, vec3(1e-9), equal(direction, vec3(0.0)));
    vec3 near = (-sign(inverse) * halfExtents - origin) * inverse;
    vec3 far = (sign(inverse) * halfExtents - origin) * inverse;
    return Slabs(near, far, max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}
