// One thread a body that clips move: how far it moves in the substep, from where it is to where its clip has it at the
// substep's end. So what it touches sees its speed, at any frame rate. PUPPETS: also stores where clips have bodies
// that may be driven, whatever those do now.
#include "shared/animation_types.h"
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
READ_BUFFER(Animation, Animations, animations);
READ_BUFFER(ClipPlay, ClipPlays, clipPlays);
#include "sim/animation/clip_mix.glsl"
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
#ifdef PUPPETS
#include "sim/animation/puppet_place.glsl"
BUFFER(vec4, ClipBodyTurns, clipBodyTurns);
BUFFER(vec4, ClipBodyPlaces, clipBodyPlaces);
#endif

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= sim.animatedCount) return;
    AnimatedBody body = animatedBodies[k];
    uint m = body.mover;
    bool animated = moves(m) && !responds(m);
#ifndef PUPPETS
    if (!animated) return;
#endif
    Animation animation = animations[body.animation];
    Mix mixed = mixAt(animation, double(counters[0].substep + 1u) * double(sim.substepTime));
#ifdef PUPPETS
    PuppetState puppet = PuppetState(PUPPET_FIRST, 0u, 0u, vec3(0), 0.0);
    if (animation.puppet != NONE) puppet = fetchPuppet(animation.puppet);
    float left = leftAt(puppet, counters[0].substep + 1u);
#endif
    // From the body up to the first: places in the rest pose of each. Each round has its own struct: NVIDIA's compiler
    // reads parts of a struct that takes its own parent's place from the grandparent.
    uint at = k, next = k;
    vec3 place = body.centre.xyz;
    vec4 turned = vec4(0, 0, 0, 1);
    for (uint depth = 0u; depth < sim.animatedCount && next != NONE; ++depth) {
        at = next;
        AnimatedBody part = animatedBodies[at];
        vec4 turn = turnOf(mixed, part);
#ifdef PUPPETS
        if (depth == 0u) clipBodyTurns[k] = turn;
        if (left > 0.0 && part.parent != NONE)
            turn = quaternionProduct(leftOf(texelFetch(catchOffsets, int(2u * at)), left), turn);
#endif
        place = rotate(turn, place - part.anchor.xyz);
        turned = quaternionProduct(turn, turned);
        next = part.parent;
        if (next != NONE) place += part.anchor.xyz;
    }
    vec3 pivot = pivotAt(mixed);
    Placed placed = placedIn(animation, Placed(place + pivot, turned));
#ifdef PUPPETS
    placed = putByCatch(puppet, placed);
    clipBodyPlaces[2u * k] = vec4(placed.place, 0);
    clipBodyPlaces[2u * k + 1u] = placed.turned;
    if (!animated) return;
    if (left > 0.0) {
        // The rest of the offset turns about the first body.
        AnimatedBody first = animatedBodies[at];
        vec3 centre = rotate(turnOf(mixed, first), first.centre.xyz - first.anchor.xyz) + pivot;
        centre = putByCatch(puppet, placedIn(animation, Placed(centre, turned))).place;
        placed = offsetBy(placed, centre, at, left);
    }
#endif
    vec4 delta = normalize(quaternionProduct(placed.turned, conjugate(fetchRotation(m))));
    moverMoves[m] = packMove(MoverMove(placed.place - fetchCentre(m), 0.0));
    moverRotationDeltas[m] = delta.w < 0.0 ? -delta : delta;
}
