// One contact as an accumulated impulse, in units of mass times displacement [kg m].
#include "shared/contact_constants.h"
#include "sim/common/contacts/contacts.glsl"

// The speed above which two grains slide, over that of a fall by half a diameter (Froude number).
#define GRAIN_STICKING 0.3

/// What a contact is made of.
struct Contact {
    vec3 normal;              // towards the first side
    float touch;              // distance at which the two touch; with a collider: the particle's diameter [m]
    float gap;                // now, negative in penetration [m]
    float startGap;           // at the start of the substep [m]
    vec3 slide;               // relative displacement since then [m]
    float leaving;            // move along the normal since then of the side that leaves the other faster [m]
    bool sameAssembly;        // both sides are of one assembly
    float inverseMass;        // of both sides together along the normal, each split over its impulses [1/kg]
    float worstInverseMass;   // the same for the worst direction; 0 if neither side responds [1/kg]
    vec2 friction;            // static, kinetic
    float stickSpeed;         // it sticks while it slides more slowly [m/s]
    float memory;             // part of its normal impulse that it keeps
};

/// Contacts of grains forget nothing: what fades has to be pressed back in, so a high column would shrink. Two grains
/// stick up to a speed that grows with their size, so that slow slides do not creep on.
/// @param excess of both sides' radii (sim/common/contacts/touch.glsl); of a collider, of the particle.
void setKind(inout Contact c, vec2 excess)
{
    bool grains = excess.x != 0.0 && excess.y != 0.0;
    c.stickSpeed = grains ? GRAIN_STICKING * sqrt(length(sim.gravity.xyz) * sim.diameter) : STICK_SPEED;
    c.memory = grains ? 1.0 : c.sameAssembly ? LIMB_MEMORY : sim.warmStart;
}

/// One Jacobi iteration of an impulse. Only contacts that were counted beforehand act, because the mass is split over
/// those; so a contact that will act in the next iteration says so (ABOUT_TO_ACT).
/// - Per substep the normal part corrects `correction` of an old penetration, the less the faster a side leaves, so
///   that the contacts of a heap do not all add to one speed.
/// - Two sunk sides part at that speed and no faster: the contact pulls by as much as recovery may push in a substep,
///   and its friction grips.
/// - The normal part fades towards its mean over some 400 substeps, which calms the waves that recovery feeds.
/// - For limbs of one assembly the last two do not hold, or they would fight their joints.
/// - Friction is Coulomb's, bounded by the accumulated normal impulse (Macklin et al. 2014, eq. 24).
/// @param mean of the normal part; updated.
Impulse solveContact(Contact c, Impulse impulse, inout float mean)
{
#ifdef SLEEP
    if (c.worstInverseMass == 0.0 && impulse.normal > 0.0) return impulse;   // both sides sleep
#endif
    float depth = max(-c.startGap, 0.0);
    bool sunk = !c.sameAssembly && depth > (1.0 - SUNK) * c.touch;
    float slowed = c.sameAssembly ? LIMB_RECOVERY
                                  : clamp(1.0 - c.leaving / (LEAVING_SPEED * sim.substepTime), LEAST_RECOVERY, 1.0);
    float error = c.gap + depth - min(sim.correction * depth, sim.maxCorrection * slowed);
    bool acts = impulse.normal != 0.0 && c.worstInverseMass > 0.0;
    float push = acts ? error / c.inverseMass : 0.0;
    float most = sunk && acts ? sim.maxCorrection / c.inverseMass : 0.0;
    float last = sunk && impulse.normal < 0.0 ? min(dot(impulse.whole, c.normal), 0.0) : max(impulse.normal, 0.0);
    // Limbs that have passed through each other stay so: their remembered impulse is not turned about.
    if (c.sameAssembly) last = min(last, max(dot(impulse.whole, c.normal), 0.0));
    mean += (last < mean ? MEAN_FALL : 1.0) * sim.meanRate * (max(last, 0.0) - mean);
    float wave = c.sameAssembly || last <= 0.0 ? 0.0 : min(last - mean, SHOCK * mean);
    float kept = c.memory * (last - sim.impulseDamping * wave);
    float whole = max(kept - push, -most);
    float normal = max(whole, 0.0), bound = max(whole, SUNK_GRIP * most);
    vec3 tangent = impulse.whole - (acts ? 1.0 / c.worstInverseMass : 0.0) * c.slide;
    tangent -= c.normal * dot(c.normal, tangent);
    float size = length(tangent);
    bool slides = length(c.slide - c.normal * dot(c.normal, c.slide)) > c.stickSpeed * sim.substepTime;
    float friction = slides ? c.friction.y : c.friction.x;
    if (size > c.friction.x * bound) tangent *= min(friction * bound / max(size, 1e-20), 1.0);
    bool soon = 2.0 * c.gap < c.startGap;   // it will overlap after another move like this one
    return Impulse(tangent + whole * c.normal, normal > 0.0 ? normal : soon || sunk ? ABOUT_TO_ACT : 0.0);
}
