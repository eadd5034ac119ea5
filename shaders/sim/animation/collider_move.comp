// One thread a collider that a clip moves: puts it where the clip has it at the substep's end, and notes its move. Asks
// for a new search when it is too far from where contacts were found. AHEAD: at the start of a step, only notes how far
// it moves until the step's end, since fluids find their colliders once a step.
#include "shared/animation_types.h"
#include "shared/contact_constants.h"
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(MovingCollider, MovingColliders, movingColliders);
READ_BUFFER(Animation, Animations, animations);
READ_BUFFER(ClipPlay, ClipPlays, clipPlays);
#include "sim/animation/clip_mix.glsl"
BUFFER(Counters, CountersBlock, counters);
#ifdef AHEAD
uniform samplerBuffer colliderPlaces;
BUFFER(float, ColliderAheads, colliderAheads);
#else
BUFFER(vec4, ColliderPlaces, colliderPlaces);
BUFFER(vec4, ColliderMoves, colliderMoves);
BUFFER(vec4, ColliderFounds, colliderFounds);   // two a thread: as colliderPlaces, w: number of searches at that time
#endif

/// Where a clip has a collider after so many substeps.
Placed placeAfter(MovingCollider moving, uint substeps)
{
    Animation animation = animations[moving.animation];
    Mix mixed = mixAt(animation, double(substeps) * double(sim.substepTime));
    vec4 turn = turnOf(mixed, AnimatedBody(0u, NONE, 0u, 0u, vec4(0), vec4(0)));
    vec3 place = rotate(turn, moving.position.xyz) + pivotAt(mixed);
    Placed own = Placed(place, quaternionProduct(turn, moving.orientation));
    Placed placed = placedIn(animation, own);
    return Placed(placed.place, normalize(placed.turned));
}

vec4 turnBetween(vec4 from, vec4 to)
{
    vec4 turn = normalize(quaternionProduct(to, conjugate(from)));
    return turn.w < 0.0 ? -turn : turn;
}

/// An upper bound of how far any point of a collider moves from one place to another [m].
float farthest(vec3 shift, vec4 turn, float reach)
{
    return length(shift) + 2.0 * length(turn.xyz) * reach;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.movingColliderCount) return;
    MovingCollider moving = movingColliders[k];
    uint first = 2u * moving.collider, second = first + 1u;
#ifdef AHEAD
    Placed next = placeAfter(moving, counters[0].substep + sim.substeps);
    colliderAheads[moving.collider] = farthest(next.place - texelFetch(colliderPlaces, int(first)).xyz,
                                               turnBetween(texelFetch(colliderPlaces, int(second)), next.turned),
                                               moving.reach);
#else
    Placed next = placeAfter(moving, counters[0].substep + 1u);
    vec3 before = colliderPlaces[first].xyz, shift = next.place - before;
    vec4 turned = colliderPlaces[second], turn = turnBetween(turned, next.turned);
    if (length(shift) <= STANDING * (1.0 + length(before)) && 2.0 * length(turn.xyz) <= STANDING) {
        next = Placed(before, turned);
        shift = vec3(0);
        turn = vec4(0, 0, 0, 1);
    }
    colliderMoves[first] = vec4(shift, farthest(shift, turn, moving.reach));
    colliderMoves[second] = turn;
    // If there was a search in the last substep, it found the collider where that substep ended.
    if (floatBitsToUint(colliderFounds[2u * k].w) != counters[0].searchCount) {
        colliderFounds[2u * k] = vec4(before, uintBitsToFloat(counters[0].searchCount));
        colliderFounds[2u * k + 1u] = turned;
    }
    vec4 since = turnBetween(colliderFounds[2u * k + 1u], next.turned);
    if (farthest(next.place - colliderFounds[2u * k].xyz, since, moving.reach) > sim.drift) counters[0].due = 1u;
    colliderPlaces[first] = vec4(next.place, 0);
    colliderPlaces[second] = next.turned;
#endif
}
