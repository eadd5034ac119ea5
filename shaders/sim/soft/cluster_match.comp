// One thread a cluster of a soft body: its centre c, the linear map F nearest to its particles (Mueller et al. 2005,
// A = sum of m (x - c) r^T times the inverse moments), F's rotation R, and how it pulls a particle: by
// m (pull r - grip (x - c - F r)), where pull is Hooke's law for R^T F - 1 and grip holds what is not linear. As
// (F - R) F^T is symmetric, it turns nothing; as the r of a cluster sum to zero, it moves nothing as a whole.
// FIRST_ITERATION: beforehand it flows, if it is plastic.
#include "sim/common/kernel.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/links.glsl"
#include "sim/soft/cluster_stress.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer clusterInfo;
uniform samplerBuffer clusterMoments;    // inverse moments [1/(kg m2)], mass, 1 / extent [1/m2]; empty directions
uniform samplerBuffer softMatter;        // two texels: GpuSoftMatter
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverMoves;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer assemblyState;
BUFFER(vec4, ClusterRotations, clusterRotations);
BUFFER(vec4, ClusterRests, clusterRests);   // columns
BUFFER(vec4, ClusterPulls, clusterPulls);   // origin, grip; c - origin, steepest; columns of pull + grip F

GpuSoftMatter matterOf(uint softBody)
{
    vec4 a = texelFetch(softMatter, int(2u * softBody)), b = texelFetch(softMatter, int(2u * softBody + 1u));
    return GpuSoftMatter(a.x, a.y, a.z, a.w, b.x, b.y, b.z, 0.0);
}

/// The rotation of the map, and its strain in the axes at rest, after what it has flowed by.
mat3 rotationOf(uint c, mat3 map, mat3 rest, out mat3 strain)
{
    vec4 q = clusterRotations[c];
    mat3 elastic = map * inverse(rest);
    q = normalize(quaternionProduct(matchedRotationDelta(elastic, q, vec4(0, 0, 0, 1)), q));
    clusterRotations[c] = q;
    mat3 rotation = matrixFromQuaternion(q);
    mat3 stretch = transpose(rotation) * elastic + fetchSymmetric(clusterMoments, int(4u * c + 2u));
    strain = 0.5 * (stretch + transpose(stretch)) - mat3(1);
    return rotation;
}

void main()
{
    uint c = gl_GlobalInvocationID.x;
    if (c >= sim.clusterCount) return;
    uvec4 info = texelFetch(clusterInfo, int(c));
    // Places from the first particle's, so that rounding is a share of the cluster's size.
    uint first = texelFetch(particleRanks, int(fetchLink(info.x).particle)).x;
    vec3 origin = texelFetch(moverCentres, int(first)).xyz, centre = vec3(0);
    mat3 now = mat3(0), before = mat3(0);
    for (uint l = info.x; l < info.x + info.y; ++l) {
        LinkValues link = fetchLink(l);
        int mover = int(texelFetch(particleRanks, int(link.particle)).x);
        vec3 start = texelFetch(moverCentres, mover).xyz - origin, move = texelFetch(moverMoves, mover).xyz;
        centre += link.mass * (start + move);
        before += outerProduct(link.mass * start, link.r);
        now += outerProduct(link.mass * (start + move), link.r);
    }
    GpuSoftMatter matter = matterOf(info.z);
    mat3 inverseMoments = fetchSymmetric(clusterMoments, int(4u * c));
    float mass = texelFetch(clusterMoments, int(4u * c)).w, grip = texelFetch(clusterMoments, int(4u * c + 1u)).w;
    mat3 map = now * inverseMoments, mapBefore = before * inverseMoments, strain;
    mat3 rest = mat3(clusterRests[3u * c].xyz, clusterRests[3u * c + 1u].xyz, clusterRests[3u * c + 2u].xyz);
    mat3 rotation = rotationOf(c, map, rest, strain);
#ifdef FIRST_ITERATION
    mat3 next = matter.creep > 0.0 ? flowed(matter, rest, strain) : rest;
    for (int column = 0; column < 3; ++column) clusterRests[3u * c + uint(column)] = vec4(next[column], 0);
#endif
    // A force f displaces by h^2 f / m at the end of a substep, of BDF2 by 4/9 of it.
    float h = sim.substepTime;
    float share = texelFetch(assemblyState, int(info.w)).y == 2u ? 4.0 / 9.0 : 1.0;
    grip *= share * h * h * matter.shear;
    mat3 stress = (share * h * h) * rotation * hooke(matter, strain) * transpose(inverse(rest)) +
                  (share * h) * map * viscousStress(matter, map, mapBefore);
    mat3 pull = grip * map - mass * stress * inverseMoments;
    clusterPulls[5u * c] = vec4(origin, grip);
    clusterPulls[5u * c + 1u] = vec4(centre / mass, share * h * (h + matter.damping) * matter.steepest);
    for (int column = 0; column < 3; ++column) clusterPulls[5u * c + 2u + uint(column)] = vec4(pull[column], 0);
}
