// Where a puppet is, where its clips have it, and where the clips are put when it is caught. A kernel declares
// READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies).
#include "math/quaternion.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/bodies/puppet_states.glsl"

uniform samplerBuffer clipBodyPlaces;    // centre, rotation

struct Place {
    vec3 centre;
    vec4 rotation;
};

Place clipPlace(uint k)
{
    return Place(texelFetch(clipBodyPlaces, int(2u * k)).xyz, texelFetch(clipBodyPlaces, int(2u * k + 1u)));
}

Place ownPlace(uint k)
{
    uint m = animatedBodies[k].mover;
    return Place(fetchCentre(m), fetchRotation(m));
}

/// The height of a body's lowest particle [m].
float lowestOf(uint k, Place at)
{
    Body body = fetchBody(animatedBodies[k].mover);
    float lowest = 1e30;
    for (uint l = body.linkStart; l < body.linkStart + body.linkCount; ++l)
        lowest = min(lowest, at.centre.y + rotate(at.rotation, fetchLink(l).r).y);
    return lowest;
}

/// Turns the puppet's clips to where it looks, and puts them under its first body, on what it stands or lies on.
void putHere(Puppet puppet, uint root, inout PuppetState s)
{
    Place is = ownPlace(root), clip = clipPlace(root);
    vec4 turn = quaternionProduct(is.rotation, conjugate(clip.rotation));
    s.yaw = length(turn.yw) > 1e-3 ? 2.0 * atan(turn.y, turn.w) : 0.0;
    vec4 about = quaternionFromRotation(vec3(0, s.yaw, 0));
    float lowest = 1e30, clipLowest = 1e30;
    for (uint k = puppet.firstBody; k < puppet.firstBody + puppet.bodyCount; ++k) {
        lowest = min(lowest, lowestOf(k, ownPlace(k)));
        clipLowest = min(clipLowest, lowestOf(k, clipPlace(k)));
    }
    s.shift = is.centre - rotate(about, clip.centre);
    s.shift.y = lowest - clipLowest;
}
