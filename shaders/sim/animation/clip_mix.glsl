// State of an animation at a moment: one clip, or two while the earlier one fades out. A kernel declares
// READ_BUFFER(ClipPlay, ClipPlays, clipPlays).
#include "sim/animation/clip_play.glsl"

/// Two plays at a moment, and how much the later one counts.
struct Mix {
    ClipPlay before, now;
    Moment beforeAt, nowAt;
    float part;
};

Mix mixAt(Animation animation, double time)
{
    uint now = animation.firstPlay;
    while (now + 1u < animation.firstPlay + animation.playCount && double(clipPlays[now + 1u].at) <= time) ++now;
    ClipPlay play = clipPlays[now];
    bool fades = now > animation.firstPlay && time < double(play.at) + double(play.fade);
    ClipPlay before = clipPlays[fades ? now - 1u : now];
    float way = fades ? float((time - double(play.at)) / double(play.fade)) : 1.0;
    return Mix(before, play, momentOf(before, time), momentOf(play, time), way * way * (3.0 - 2.0 * way));
}

/// A body in the world: its centre [m] and its turn from the rest pose.
struct Placed {
    vec3 place;
    vec4 turned;
};

Placed placedIn(Animation animation, Placed p)
{
    return Placed(rotate(animation.rotation, p.place) + animation.position.xyz,
                  quaternionProduct(animation.rotation, p.turned));
}

/// The place of the pivot, before the animation is placed in the world [m].
vec3 pivotAt(Mix mixed)
{
    return mix(pivotOf(mixed.before, mixed.beforeAt), pivotOf(mixed.now, mixed.nowAt), mixed.part);
}

/// The turn of a body against its parent; of the first body, in the animation's frame.
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
