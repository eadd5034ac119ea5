// The part of the smoothing kernel that static colliders cover. Its slope is the gradient of one function of the walls'
// places: otherwise a particle that goes round in a corner would gain energy each time.

struct WallCover {
    vec3 gradient;   // of the fraction [1/m]
    float fraction;
    mat3 moment;     // what it adds to M of fluid_shape, besides the fraction
};

struct Wall {
    vec3 normal;
    float distance;
    float fraction, slope;   // what it covers alone, and the change of that along its normal [1/m]
};

Wall wallOf(uint index, vec3 x)
{
    ColliderSurface surface = colliderSurface(index, x);
    vec2 covered = wallFraction(surface.distance);
    return Wall(surface.normal, surface.distance, covered.x, covered.y);
}

/// The share of what a wall covers that earlier walls do not cover.
struct Uncovered {
    float share, byOwn;   // its change with what the wall covers
    vec3 byOthers;        // and, through what the others cover, with position [1/m]
};

/// Subtracts what another wall covers of it: for walls at right angles the product, for parallel ones the smaller,
/// nothing for walls that face each other.
Uncovered without(Uncovered left, Wall wall, Wall other)
{
    float along = dot(wall.normal, other.normal), alike = max(along, 0.0), crossing = 1.0 - abs(along);
    bool behind = other.fraction < wall.fraction;
    float inverse = 1.0 / max(wall.fraction, 1e-20), part = behind ? other.fraction * inverse : 1.0;
    float share = max(1.0 - crossing * other.fraction - alike * part, 0.0);
    float byOther = -crossing - (behind ? alike * inverse : 0.0), byWall = behind ? alike * part * inverse : 0.0;
    return Uncovered(left.share * share, left.byOwn * share + left.share * byWall,
                     left.byOthers * share + left.share * byOther * other.slope * other.normal);
}

void add(inout WallCover sum, Wall wall, Uncovered left)
{
    sum.fraction += wall.fraction * left.share;
    sum.moment -= left.share * max(wall.distance, 0.0) * wall.slope * outerProduct(wall.normal, wall.normal);
    sum.gradient += (left.share + wall.fraction * left.byOwn) * wall.slope * wall.normal +
                    wall.fraction * left.byOthers;
}

/// What the colliders near a slot cover for a particle at x. Each collider is followed by those before it, one a round:
/// a software driver runs every loop once even where no lane needs it.
WallCover wallCover(uint slot, vec3 x)
{
    WallCover sum = WallCover(vec3(0), 0.0, mat3(0));
    NearColliders near = nearColliders(slot), before = near;
    bool any = nextCollider(near), isOwn = true;
    Wall wall = Wall(vec3(0), 0.0, 0.0, 0.0);
    Uncovered left = Uncovered(1.0, 0.0, vec3(0));
    do {
        Wall seen = wallOf(isOwn ? near.index : before.index, x);
        if (isOwn) wall = seen, left = Uncovered(1.0, 0.0, vec3(0)), before = nearColliders(slot);
        else if (seen.fraction > 0.0) left = without(left, wall, seen);
        isOwn = !any || wall.fraction <= 0.0 || !nextCollider(before) || before.index >= near.index;
        if (!isOwn) continue;
        if (any && wall.fraction > 0.0) add(sum, wall, left);
        any = any && nextCollider(near);
    } while (any);
    return sum;
}
