// One thread a body that clips move: how far it comes in the substep, from where it is to where they have it at the
// substep's end. What it meets so sees its speed, at any frame rate. PUPPETS: where clips have bodies that may be
// driven, whatever those do now.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/animation/clip_play.glsl"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
READ_BUFFER(GpuAnimation, Animations, animations);
READ_BUFFER(GpuClipPlay, ClipPlays, clipPlays);
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
#ifdef PUPPETS
BUFFER(vec4, ClipBodyTurns, clipBodyTurns);
BUFFER(vec4, ClipBodyPlaces, clipBodyPlaces);
#endif

/// Two plays at a moment, and how much the later one counts.
struct Mix {
    GpuClipPlay before, now;
    Moment beforeAt, nowAt;
    float part;
};

Mix mixAt(GpuAnimation animation, double time)
{
    uint now = animation.firstPlay;
    while (now + 1u < animation.firstPlay + animation.playCount && double(clipPlays[now + 1u].at) <= time) ++now;
    GpuClipPlay play = clipPlays[now];
    bool fades = now > animation.firstPlay && time < double(play.at) + double(play.fade);
    GpuClipPlay before = clipPlays[fades ? now - 1u : now];
    float way = fades ? float((time - double(play.at)) / double(play.fade)) : 1.0;
    return Mix(before, play, momentOf(before, time), momentOf(play, time), way * way * (3.0 - 2.0 * way));
}

/// Of a body against its parent; of the first one where the animation is put.
vec4 turnOf(Mix mixed, AnimatedBody body)
{
    vec4 before = sampleTurn(mixed.before, mixed.beforeAt, body.turn);
    vec4 now = sampleTurn(mixed.now, mixed.nowAt, body.turn);
    if (body.parent == NONE) {
        before = quaternionProduct(aboutY(yawOf(mixed.before, mixed.beforeAt)), before);
        now = quaternionProduct(aboutY(yawOf(mixed.now, mixed.nowAt)), now);
    }
    if (dot(before, now) < 0.0) before = -before;
    return normalize(mix(before, now, mixed.part));
}

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
    GpuAnimation animation = animations[body.animation];
    Mix mixed = mixAt(animation, double(counters[0].substep + 1u) * double(sim.substepTime));
    // From the body up to the first: places in the rest pose of each.
    vec3 place = body.centre.xyz;
    vec4 turned = vec4(0, 0, 0, 1);
    for (uint depth = 0u; depth < sim.animatedCount; ++depth) {
        vec4 turn = turnOf(mixed, body);
#ifdef PUPPETS
        if (depth == 0u) clipBodyTurns[k] = turn;
#endif
        place = rotate(turn, place - body.anchor.xyz);
        turned = quaternionProduct(turn, turned);
        if (body.parent == NONE) break;
        place += body.anchor.xyz;
        body = animatedBodies[body.parent];
    }
    place += mix(pivotOf(mixed.before, mixed.beforeAt), pivotOf(mixed.now, mixed.nowAt), mixed.part);
    place = rotate(animation.rotation, place) + animation.position.xyz;
    turned = quaternionProduct(animation.rotation, turned);
#ifdef PUPPETS
    clipBodyPlaces[2u * k] = vec4(place, 0);
    clipBodyPlaces[2u * k + 1u] = turned;
    if (!animated) return;
#endif
    vec4 delta = normalize(quaternionProduct(turned, conjugate(fetchRotation(m))));
    moverMoves[m] = packMove(MoverMove(place - fetchCentre(m), 0.0));
    moverRotationDeltas[m] = delta.w < 0.0 ? -delta : delta;
}
