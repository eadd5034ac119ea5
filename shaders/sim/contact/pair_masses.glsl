// The masses that the impulse of a pair meets.
#include "sim/contact/contact_impulse.glsl"

/// Sets friction and masses of a contact. @param splits number of impulses over which the mass of each side is split.
void setMasses(inout Contact contact, ContactSides sides, Arm armA, Arm armB, vec2 splits)
{
    vec2 worst = vec2(armA.worstInverseMass, armB.worstInverseMass) * splits;
    contact.worstInverseMass = worst.x + worst.y;
    contact.inverseMass = dot(worst, sides.fractions);
    contact.friction = sides.friction;
}
