// One contact of the paper's solver: the impulse that it asks for, before the average over the contacts of a particle.
// STABILIZE: for the overlap at the start of the substep, which leaves without adding speed.
#include "shared/one_sided.glsl"

/// A particle as a contact sees it.
struct Side {
    vec3 start;          // at the start of the substep [m]
    vec3 move;           // since then [m]
    float inverseMass;   // 0: immovable [1/kg]
};

/// What contacts ask of a particle.
struct Push {
    vec3 impulse;        // [kg m]
    float acting;        // how many contacts act
};

/// How far a contact has to be pushed apart [m], <= 0. An overlap is all that is known of the load that presses it, so
/// the first `maxCorrection` of an old one push with speed and the rest is left to stabilization. What is deeper than
/// `deepOverlap` carries nothing any more, it only has to come out.
float contactError(float gap, float startGap)
{
    float old = max(-startGap, 0.0);
    bool deep = old > step.deepOverlap;
#ifdef STABILIZE
    return deep ? -step.deepRecovery : -clamp(old - step.maxCorrection, 0.0, step.stabilization);
#else
    return min(gap + (deep ? old : max(old - step.maxCorrection, 0.0)), 0.0);
#endif
}

/// An overlap (eqs. 5-7) and its friction (Macklin et al. 2014, eq. 24).
/// @param slide of the first side on the second in the substep [m]. @param friction static, kinetic.
Push contactPush(vec3 normal, float gap, float startGap, vec3 slide, float inverseMass, vec2 friction)
{
    float error = contactError(gap, startGap);
    if (error >= 0.0 || inverseMass == 0.0) return Push(vec3(0), 0.0);
    vec3 apart = -error * normal;
#ifndef STABILIZE
    vec3 tangent = slide - normal * dot(normal, slide);
    float size = length(tangent);
    apart -= (size < -friction.x * error ? 1.0 : min(-friction.y * error / max(size, 1e-20), 1.0)) * tangent;
#endif
    return Push(apart / inverseMass, 1.0);
}

/// What the contact of two particles asks of the first; the second gets the opposite.
/// @param sides of the pair, pairSides.
Push pairPush(Side a, Side b, uvec4 sides)
{
    vec3 startApart = a.start - b.start, slide = a.move - b.move;
    float startFar = length(startApart);
    Way way = unpackWay(sides.xy);
    vec4 sided = sidedNormal(startApart, startFar, way);
    bool keeps = sided.w > 0.0;
    float startGap = (keeps && way.deep ? 0.0 : startFar) - step.diameter;
    vec3 apart = startApart + slide;
    float far = length(apart);
    vec3 normal = keeps ? sided.xyz : contactNormal(apart, far, true);
    float gap = keeps ? startGap + dot(slide, sided.xyz) : far - step.diameter;
    return contactPush(normal, gap, startGap, slide, a.inverseMass + b.inverseMass, unpackHalf2x16(sides.z));
}
