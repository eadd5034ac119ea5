// What static colliders cover of the smoothing kernel.

struct WallCover {
    vec3 gradient;   // of the fraction [1/m]
    float fraction;
};

/// Adds what a wall covers (fraction, slope) to what others do, less what both cover: the product of their fractions
/// where they stand at right angles, the smaller where they are parallel, nothing where they face each other.
WallCover addWall(WallCover others, vec3 normal, vec2 wall)
{
    float along = -dot(normal, others.gradient) / max(length(others.gradient), 1e-20), alike = max(along, 0.0);
    float crossing = 1.0 - abs(along);
    vec2 both = crossing * vec2(wall.x, others.fraction) +
                alike * (others.fraction < wall.x ? vec2(1, 0) : vec2(0, 1));
    float twice = crossing * others.fraction * wall.x + alike * min(others.fraction, wall.x);
    return WallCover((1.0 - both.x) * others.gradient + (1.0 - both.y) * wall.y * normal,
                     others.fraction + wall.x - twice);
}

/// Whether a wall is nearer than another. Distances of walls that coincide differ by rounding: the first is nearer.
bool isNearer(uint index, ColliderSurface wall, uint otherIndex, ColliderSurface other)
{
    float rounding = 1e-3 * sim.fluidSpacing;
    return wall.distance < other.distance + (index < otherIndex ? rounding : -rounding);
}

/// The part of a wall that no nearer one stands in front of: 0 behind a parallel one, 1 where they differ by 11 degrees
/// or more. Without it a second floor would count in corners, where what the others cover together leans.
float inFront(uint slot, vec3 x, uint index, ColliderSurface wall)
{
    float part = 1.0;
    for (NearColliders near = nearColliders(slot); nextCollider(near);) {
        if (near.index == index) continue;
        ColliderSurface other = colliderSurface(near.index, x);
        if (isNearer(near.index, other, index, wall))
            part *= clamp(50.0 * (1.0 - dot(other.normal, wall.normal)), 0.0, 1.0);
    }
    return part;
}

/// What the colliders near a slot cover for a particle at x.
WallCover wallCover(uint slot, vec3 x)
{
    WallCover sum = WallCover(vec3(0), 0.0);
    for (NearColliders near = nearColliders(slot); nextCollider(near);) {
        ColliderSurface wall = colliderSurface(near.index, x);
        vec2 covered = wallFraction(wall.distance);
        if (covered.x > 0.0) sum = addWall(sum, wall.normal, inFront(slot, x, near.index, wall) * covered);
    }
    return sum;
}
