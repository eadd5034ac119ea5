// Contacts of a rope's nodes with colliders, which are solved with their rope: stiff springs that only push, and grip
// up to Coulomb's bound. Their impulses are linear in how much further the node moves: push - stiffness move.
#include "shared/contact_constants.h"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/collider_moves.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/contacts/touch.glsl"

// Of a contact, by its node's mass: along the normal, and where it sticks.
layout(location = 0) uniform vec2 stiffnessPerMass;
uniform usamplerBuffer distanceNodes;
uniform usamplerBuffer ropeNodes;
uniform usamplerBuffer colliderSides;
READ_BUFFER(Counters, CountersBlock, counters);

/// Cosine of the angle between normals before and after a move along one smooth surface.
const float SAME_SIDE = 0.98;

struct RopeTouch {
    vec3 normal, slide;   // slide: of the node against the collider in the substep, along the surface [m]
    vec3 push;            // [kg m]
    mat3 stiffness;       // [kg]
};

/// How much nearer a node has come to the collider [m]. By the move, since distances differ by less than they round to.
float nearer(ColliderSurface before, ColliderSurface now, vec3 way)
{
    bool smoothly = dot(before.normal, now.normal) > SAME_SIDE;
    return smoothly ? -0.5 * dot(before.normal + now.normal, way) : before.distance - now.distance;
}

/// Friction as a drag, which never pushes a node on: what holds a slide as long as the last substep's, so that all
/// iterations ask for the same. After the first one (FIRST_ITERATION) it follows the normal impulse.
/// @param normal impulse of the last iteration. @param excess of the normal push over it.
void addFriction(inout RopeTouch c, vec2 friction, float normal, float excess, float lastSlide, float mass)
{
    float hold = stiffnessPerMass.y * mass, stiffness = stiffnessPerMass.x * mass;
    float size = max(lastSlide > 0.0 ? lastSlide : length(c.slide), 1e-20);
#ifndef FIRST_ITERATION
    size = max(size, length(c.slide));
#endif
    float bound = size > STICK_SPEED * sim.substepTime ? friction.y : friction.x;
    float drag = min(bound * normal / size, hold);
    c.push -= drag * c.slide;
    c.stiffness += drag * (mat3(1) - outerProduct(c.normal, c.normal));
#ifndef FIRST_ITERATION
    if (drag == hold) return;
    vec3 along = c.slide / max(size, length(c.slide));
    c.push -= bound * excess * along;
    c.stiffness -= bound * stiffness * outerProduct(along, c.normal);
#endif
}

/// @param start of the node in the substep, `move` since then [m]. @param last impulse: of the last iteration, or
/// FIRST_ITERATION: of the last substep. @param lastSlide in the last substep [m]; 0 if unknown.
RopeTouch ropeTouch(ColliderContact sides, vec3 start, vec3 move, float radius, vec3 last, float lastSlide, float mass)
{
    ColliderSurface now = colliderSurface(sides.collider, start + move);
    ColliderSurface before = colliderSurface(sides.collider, takenAlong(sides.collider, start));
    vec3 n = now.normal, way = move - surfaceMove(sides.collider, start + move - radius * n);
    RopeTouch c = RopeTouch(n, way - n * dot(n, way), vec3(0), mat3(0));
    float startGap = before.distance - radius, depth = max(-startGap, 0.0);
    float error = startGap + depth - nearer(before, now, way) - min(sim.correction * depth, sim.maxCorrection);
    float normal = dot(last, n), stiffness = stiffnessPerMass.x * mass;
    if (normal <= mass * error) return c;
    c.push = -stiffness * error * n;
    c.stiffness = stiffness * outerProduct(n, n);
    if (normal > 0.0) addFriction(c, sides.friction, normal, -stiffness * error - normal, lastSlide, mass);
    return c;
}

/// Of a node that is now at `move` from where it began: a contact with a collider.
RopeTouch touchOf(uint mover, float mass, uint q, vec3 move, vec3 last, float lastSlide)
{
    return ropeTouch(fetchColliderContact(colliderSides, q), fetchCentre(mover), move,
                     particleRadius(radiusExcess(mover)), last, lastSlide, mass);
}
