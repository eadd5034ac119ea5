// The inverse masses that a contact's impulse meets. Computed when contacts are found, from the places of bodies then.
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/bodies/mover_info.glsl"

uniform samplerBuffer searchRotations;

/// Of one side of a contact.
struct SideMass {
    float worst;      // the inverse mass along the normal or the worst tangent, whichever is larger [1/kg]
    float fraction;   // of it along the normal, 0 ... 1
};

/// Inverse mass of a mover for an impulse at its surface. Loose particles have the same mass in all directions.
/// @param particle the contact's particle in the body. @param r where the impulse acts, in the body's axes [m].
SideMass sideMass(uint mover, Arm particle, vec3 r, vec3 normal)
{
    if (mover >= sim.bodyCount) return SideMass(particle.worstInverseMass, 1.0);
    InverseInertia inertia = fetchInverseInertia(mover);
    mat3 inverseInertia = symmetricMatrix(inertia.diagonal, inertia.offDiagonal);
    vec3 n = rotate(conjugate(texelFetch(searchRotations, int(mover))), normal);
    vec3 along = normalize(cross(n, abs(n.x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 1, 0))), across = cross(n, along);
    vec3 turnN = cross(r, n), turnA = cross(r, along), turnC = cross(r, across);
    float a = dot(turnA, inverseInertia * turnA), c = dot(turnC, inverseInertia * turnC);
    float mixed = dot(turnA, inverseInertia * turnC);
    float tangent = 0.5 * (a + c) + length(vec2(0.5 * (a - c), mixed));   // the larger eigenvalue
    float normalTurn = max(dot(turnN, inverseInertia * turnN), 0.0);
    float worst = inertia.inverseMass + max(tangent, normalTurn);
    return SideMass(worst, (inertia.inverseMass + normalTurn) / worst);
}
