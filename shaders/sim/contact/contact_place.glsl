// Points of movers where an iteration has them.

/// From a mover's centre to the point at r in its axes, turned as it is now [m].
vec3 placeOf(uint mover, vec3 r)
{
    return rotate(quaternionProduct(fetchRotationDelta(mover), fetchRotation(mover)), r);
}

/// The point of a mover that is now at `offset` from its point r, in its axes [m].
vec3 armAt(uint mover, vec3 r, vec3 offset)
{
    return r + rotate(conjugate(quaternionProduct(fetchRotationDelta(mover), fetchRotation(mover))), offset);
}
