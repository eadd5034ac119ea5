// One thread a cluster of a soft body: its centre c, the linear map F nearest to its particles (Mueller et al. 2005, A
// = sum of m (x - c) r^T times the inverse moments), F's rotation R, and its pull on a particle: m (pull r - grip (x -
// c - F r)), where pull is Hooke's law for R^T F - 1 and grip holds the nonlinear part. As (F - R) F^T is symmetric,
// the pull turns nothing; as the r of a cluster sum to zero, it moves nothing as a whole. FIRST_ITERATION: of a
// substep; before it, a plastic cluster flows.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"
#include "sim/soft/clusters.glsl"
#include "sim/soft/cluster_stress.glsl"
#include "sim/soft/chebyshev.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(location = 0) uniform uvec4 iteration;   // of the substep; how many there are; first cluster, end
BUFFER(vec4, ClusterRotations, clusterRotations);
BUFFER(vec4, ClusterRests, clusterRests);   // three columns a cluster: the map by which it has flowed
BUFFER(vec4, ClusterPulls, newClusterPulls);

mat3 restOf(uint c)
{
    return mat3(clusterRests[3u * c].xyz, clusterRests[3u * c + 1u].xyz, clusterRests[3u * c + 2u].xyz);
}

/// The rotation of the map, and its strain in the axes at rest, both without the plastic flow.
mat3 rotationOf(uint c, mat3 map, mat3 rest, mat3 empty, out mat3 strain)
{
    vec4 q = clusterRotations[c];
    mat3 elastic = map * inverse(rest);
    q = normalize(quaternionProduct(matchedRotationDelta(elastic, q, vec4(0, 0, 0, 1)), q));
    clusterRotations[c] = q;
    mat3 rotation = matrixFromQuaternion(q);
    mat3 stretch = transpose(rotation) * elastic + empty;
    strain = 0.5 * (stretch + transpose(stretch)) - mat3(1);
    return rotation;
}

void main()
{
    uint c = iteration.z + gl_GlobalInvocationID.x;
    if (c >= iteration.w) return;
    Cluster info = fetchCluster(c);
    SoftMatter matter = fetchSoftMatter(info.softBody);
    if (!isDue(iteration.x, iteration.y, uint(matter.iterations))) {
        STORE_NO_CHANGE(newClusterPulls, c);
        return;
    }
    // Relative to the particle in the middle, so that the centre, from which momentum comes, is rounded little.
    uint middle = fetchRank(fetchLink(info.linkStart + info.linkCount / 2u).particle).mover;
    vec3 origin = texelFetch(moverCentres, int(middle)).xyz, centre = vec3(0);
    mat3 now = mat3(0), before = mat3(0);
    for (uint l = info.linkStart; l < info.linkStart + info.linkCount; ++l) {
        LinkValues link = fetchLink(l);
        int mover = int(fetchRank(link.particle).mover);
        vec3 start = texelFetch(moverCentres, mover).xyz - origin, move = texelFetch(moverMoves, mover).xyz;
        centre += link.mass * (start + move);
        before += outerProduct(link.mass * start, link.r);
        now += outerProduct(link.mass * (start + move), link.r);
    }
    ClusterMoments moments = fetchClusterMoments(c);
    mat3 map = now * moments.inverse, mapBefore = before * moments.inverse, rest = restOf(c), strain;
    mat3 rotation = rotationOf(c, map, rest, moments.empty, strain);
#ifdef FIRST_ITERATION
    mat3 next = matter.creep > 0.0 ? flowed(matter, rest, strain) : rest;
    for (int column = 0; column < 3; ++column) clusterRests[3u * c + uint(column)] = vec4(next[column], 0);
#endif
    // At the end of a substep a force f displaces by h^2 f / m, with BDF2 by less.
    float h = sim.substepTime, factor = accelerationFactor(fetchAssembly(info.assembly));
    float grip = moments.bending * (factor * h * h * matter.shear);
    mat3 stress = (factor * h * h) * rotation * hooke(matter, strain) * transpose(inverse(rest)) +
                  (factor * h) * map * viscousStress(matter, map, mapBefore);
    mat3 pull = grip * map - moments.mass * stress * moments.inverse;
    float ownIteration = float(iteration.x * uint(matter.iterations) / iteration.y);
    vec2 factors = chebyshevFactors(matter, ownIteration, factor * h * (h + matter.damping) * matter.steepest);
    ClusterPull pulled = ClusterPull(origin, centre / moments.mass, pull, grip, factors);
    STORE_CLUSTER_PULL(newClusterPulls, c, pulled);
}
