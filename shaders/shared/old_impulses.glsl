// The impulses of the lists before a new search, looked up by what the contact is with. Read as texels: only the half of
// the lists that is not being written.
#include "shared/contact_lists.glsl"

uniform usamplerBuffer oldCandidates;
uniform samplerBuffer oldImpulses;

/// The impulse that particle i had with `other`, zero when it had none. Its `count` slots begin at `first`: 0 for
/// particles, step.contactSlots for colliders.
vec4 oldImpulse(uint oldParity, uint first, uint count, uint i, uint other)
{
    for (uint s = first; s < first + count; ++s) {
        int slot = int(contactSlot(oldParity, s, i));
        if (texelFetch(oldCandidates, slot).x == other) return texelFetch(oldImpulses, slot);
    }
    return vec4(0);
}
