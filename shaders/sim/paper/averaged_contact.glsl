// One contact of the paper's solver: its move of a particle, before averaging over all of the particle's contacts.
// STABILIZE: for the overlap at the start of the substep, which is corrected without adding speed.
#include "shared/paper_constants.h"
#include "sim/common/contacts/contacts.glsl"

/// A particle as a contact sees it.
struct Side {
    vec3 start;          // at the start of the substep [m]
    vec3 move;           // since then [m]
    float inverseMass;   // as contacts see it; 0: it does not respond [1/kg]
};

/// What contacts ask of a particle.
struct Push {
    vec3 move;           // [m]
    float acting;        // how many contacts act
};

/// How far this pass has to push a contact apart [m], <= 0. The load on a contact shows only as its overlap, so the
/// first `maxCorrection` of an old one pushes with speed and the rest is left to stabilization. A contact deeper than
/// `deepOverlap` carries nothing any more, it only has to come out.
float contactError(float gap, float startGap)
{
    float old = max(-startGap, 0.0);
    bool deep = old > sim.deepOverlap;
#ifdef STABILIZE
    return deep ? -sim.deepRecovery : -clamp(old - sim.maxCorrection, 0.0, sim.stabilization);
#else
    return min(gap + (deep ? old : max(old - sim.maxCorrection, 0.0)), 0.0);
#endif
}

/// An overlap (eqs. 5-7) and its friction (Macklin et al. 2014, eq. 24).
/// @param slide of one side on the other in the substep [m]. @param friction static, kinetic.
/// @returns the move apart along the normal, before relaxation.
Push contactPush(vec3 normal, float gap, float startGap, vec3 slide, vec2 friction)
{
    float error = contactError(gap, startGap);
    Push push = Push(-error * normal, error < 0.0 ? 1.0 : 0.0);
#ifndef STABILIZE
    vec3 tangent = slide - normal * dot(normal, slide);
    float size = length(tangent);
    float slowed = size < -friction.x * error ? 1.0 : min(-friction.y * error / max(size, 1e-20), 1.0);
    push.move -= slowed * tangent;
#endif
    return push;
}

/// What the contact of two particles asks of one of them.
/// @param sides of the pair. @param first whether `own` is the first of it.
/// @param touching nearer than this they overlap [m].
Push pairPush(Side own, Side other, bool first, ContactSides sides, float touching)
{
    float sign = first ? 1.0 : -1.0;
    vec3 startApart = sign * (own.start - other.start), slide = sign * (own.move - other.move);
    float startDistance = length(startApart);
    OneSidedNormal sided = oneSidedNormal(startApart, startDistance, sides.exit, touching);
    bool keeps = sided.applies;
    float startGap = (keeps && sides.exit.deepInside ? 0.0 : startDistance) - touching;
    vec3 apart = startApart + slide;
    float distanceNow = length(apart);
    vec3 normal = keeps ? sided.normal : contactNormal(apart, distanceNow);
    float gap = keeps ? startGap + dot(slide, sided.normal) : distanceNow - touching;
    Push push = contactPush(normal, gap, startGap, slide, sides.friction);
    push.move *= sign * own.inverseMass / max(own.inverseMass + other.inverseMass, 1e-30);
    return push;
}
