// Goals of shared particles: each body has a goal for the particle, which stands at their mean.
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mover_state.glsl"
#include "sim/common/bodies/owners.glsl"

/// The goal of one owner.
PointState ownersGoal(uint entry)
{
    Owner owner = fetchOwner(entry);
    return pointState(owner.body, fetchLink(owner.link).r);
}

/// The mean of a particle's goals, summed relative to the first, which keeps rounding errors as small as their
/// distances.
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
