// Where the bodies that share a particle want it: each has a goal for it, and it stands at their mean.
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mover_state.glsl"
#include "sim/common/bodies/owners.glsl"

/// The goal of one owner.
PointState ownersGoal(uint entry)
{
    Owner owner = fetchOwner(entry);
    return pointState(owner.body, fetchLink(owner.link).r);
}

/// The mean of the goals of a particle, summed from the first, so that rounding stays as small as what is between them.
PointState meanGoal(uint particle)
{
    OwnerRange owners = fetchOwners(particle);
    PointState first = ownersGoal(owners.first);
    vec3 shift = vec3(0), change = vec3(0);
    for (uint l = owners.first + 1u; l < owners.first + owners.count; ++l) {
        PointState other = ownersGoal(l);
        shift += other.position - first.position;
        change += other.velocity - first.velocity;
    }
    return PointState(first.position + shift / float(owners.count), first.velocity + change / float(owners.count));
}
