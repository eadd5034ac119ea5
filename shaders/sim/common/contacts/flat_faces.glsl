// Boxes of particles have flat faces for contacts. Where the lattice of a box continues beside a particle, the distance
// of another particle is measured from the line or the plane through the lattice, so that its bumps catch nothing. The
// axes along which the lattice continues are the hidden axes. They are found with the pair, three bits for each side; a
// contact's direction has no part along them.
#include "shared/contact_constants.h"
#include "math/quaternion.glsl"
#include "sim/common/contacts/one_sided.glsl"

/// The axes along which a lattice continues from a particle towards another one beside it. One that is further off is
/// nearer to another particle of the lattice: several contacts would carry what one should.
/// @param ends of the lattice at the particle, bits 2 k and 2 k + 1: towards - and + along axis k.
/// @param towards the other particle, in the body's axes [m]. @param beside how far
/// off along an axis it may be [m].
uint hiddenAxes(uint ends, vec3 towards, float beside)
{
    uvec3 end = uvec3(ends) >> (uvec3(0, 2, 4) + uvec3(greaterThan(towards, vec3(0)))) & 1u;
    uvec3 hidden = (1u - end) * uvec3(lessThan(abs(towards), vec3(beside)));
    return hidden.x | hidden.y << 1 | hidden.z << 2;
}

/// A vector without its parts along hidden axes of a body with that rotation.
vec3 withoutAxes(vec3 v, vec4 rotation, uint hidden)
{
    vec3 shown = vec3(1u - (uvec3(hidden) >> uvec3(0, 1, 2) & 1u));
    return rotate(rotation, shown * rotate(conjugate(rotation), v));
}

/// The difference of the two sides of a pair, from the face or edge of whichever is nearer.
struct FlatDifference {
    vec3 difference;      // [m]
    float firstTouches;   // 1: the first side touches the second one's face, 0: the other way round; below 0: no face
};

FlatDifference flatDifference(vec3 difference, vec4 rotationA, vec4 rotationB, uint hidden, float touch)
{
    vec3 a = withoutAxes(difference, rotationA, hidden & 7u), b = withoutAxes(difference, rotationB, hidden >> 3);
    vec3 nearest = dot(a, a) < dot(b, b) ? a : b;
    float least = LEAST_FLAT * touch;
    if (dot(nearest, nearest) <= least * least) return FlatDifference(difference, -1.0);
    // Between two faces, the middle of both.
    return FlatDifference(nearest, clamp(0.5 + 5.0 * (length(a) - length(b)) / touch, 0.0, 1.0));
}

/// In which direction the sides of a pair are apart.
struct Separation {
    vec3 normal;       // towards the first
    float distance;    // of the two along it [m]
    bool oneSided;     // the normal follows the exit direction
    float firstTouches;  // as of FlatDifference
    bool keepsNormal;  // the normal stays while they move (an exit direction, a face); else it turns with the two
};

/// @param difference from the second side to the first [m]. @param rotationA, rotationB of their bodies.
/// @param touch the distance at which they touch [m].
Separation separationOf(vec3 difference, ExitDirection exit, vec4 rotationA, vec4 rotationB, uint hidden, float touch)
{
    float apart = length(difference);
    OneSidedNormal sided = oneSidedNormal(difference, apart, exit, touch);
    if (sided.applies) return Separation(sided.normal, apart, true, -1.0, true);
    FlatDifference view = FlatDifference(difference, -1.0);
    if (hidden != 0u) view = flatDifference(difference, rotationA, rotationB, hidden, touch);
    apart = length(view.difference);
    return Separation(contactNormal(view.difference, apart), apart, false, view.firstTouches, hidden != 0u);
}
