// One thread a release by a region and a body of it: lets go if the centre of a particle of the body is in the region.
#include "sim/common/kernel.glsl"
#include "sim/release/release.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/colliders.glsl"
#include "sim/common/particles.glsl"

layout(local_size_x = GROUP_SIZE) in;

void main()
{
    uint thread = gl_GlobalInvocationID.x;
    if (thread >= sim.regionWatchCount) return;
    ReleaseWatch watched = fetchReleaseWatch(sim.impulseWatchCount + sim.touchWatchCount + thread);
    Release release = releases[watched.release];
    Mover body = fetchMover(watched.body);
    vec3 centre = fetchCentre(watched.body);
    vec4 rotation = fetchRotation(watched.body);
    bool inside = false;
    for (uint rank = body.firstRank; rank < body.firstRank + body.rankCount; ++rank) {
        vec3 place = centre + rotate(rotation, fetchArm(fetchRankedParticle(rank)).r);
        inside = inside || colliderSurface(release.region, place).distance < 0.0;
    }
    if (inside) letGo(release);
}
