// Impulses of contacts, as their buffers hold them.
#include "shared/contact_constants.h"

/// An accumulated impulse on the first side of a contact; for restitution, what the last iteration added.
struct Impulse {
    vec3 whole;    // [kg m]; restitution: [kg m/s]
    float normal;  // its normal part; ABOUT_TO_ACT if there is none yet but will be, 0 if none acts
};

Impulse unpackImpulse(vec4 t)
{
    return Impulse(t.xyz, t.w);
}

Impulse fetchImpulse(samplerBuffer impulses, uint index)
{
    return unpackImpulse(texelFetch(impulses, int(index)));
}

vec4 packImpulse(Impulse impulse)
{
    return vec4(impulse.whole, impulse.normal);
}
