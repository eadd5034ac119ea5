// Clusters of soft bodies: what never changes about them, and their pull on particles.
#include "sim/common/bodies/bodies.glsl"

uniform usamplerBuffer clusterInfo;
uniform samplerBuffer clusterMoments;
uniform samplerBuffer softMatter;
uniform samplerBuffer clusterPulls;

Cluster fetchCluster(uint c)
{
    uvec4 t = texelFetch(clusterInfo, int(c));
    return Cluster(t.x, t.y, t.z, t.w);
}

/// Distribution of a cluster's mass at rest.
struct ClusterMoments {
    mat3 inverse;         // of the sum of m r r^T [1/(kg m2)]; zero along empty directions
    mat3 empty;           // the sum of d d^T over directions d in which it has no extent
    float mass;           // [kg]
    float bending;        // what holds a bend within it, over the shear modulus [1/m2]
};

ClusterMoments fetchClusterMoments(uint c)
{
    int first = int(4u * c);
    vec4 diagonal = texelFetch(clusterMoments, first), offDiagonal = texelFetch(clusterMoments, first + 1);
    mat3 empty = symmetricMatrix(texelFetch(clusterMoments, first + 2).xyz, texelFetch(clusterMoments, first + 3).xyz);
    return ClusterMoments(symmetricMatrix(diagonal.xyz, offDiagonal.xyz), empty, diagonal.w, offDiagonal.w);
}

SoftMatter fetchSoftMatter(uint softBody)
{
    int first = int(3u * softBody);
    vec4 a = texelFetch(softMatter, first), b = texelFetch(softMatter, first + 1);
    vec4 c = texelFetch(softMatter, first + 2);
    return SoftMatter(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, c.x, c.y, float[2](0.0, 0.0));
}

/// The impulse that a cluster gives a particle of mass m that is at x: m (pull r - grip (x - centre)).
struct ClusterPull {
    vec3 origin;      // where its middle particle was when the substep began [m]
    vec3 centre;      // from there [m]
    mat3 pull;
    float grip;
    vec2 factors;     // chebyshevFactors()
};

/// Those of an iteration in which its particles stay.
const vec2 NO_CHANGE = vec2(0);

vec2 fetchChebyshevFactors(uint c)
{
    return vec2(texelFetch(clusterPulls, int(5u * c + 1u)).w, texelFetch(clusterPulls, int(5u * c + 2u)).w);
}

ClusterPull fetchClusterPull(uint c)
{
    int first = int(5u * c);
    vec4 origin = texelFetch(clusterPulls, first), centre = texelFetch(clusterPulls, first + 1);
    vec4 column = texelFetch(clusterPulls, first + 2);
    mat3 pull = mat3(column.xyz, texelFetch(clusterPulls, first + 3).xyz,
                     texelFetch(clusterPulls, first + 4).xyz);
    return ClusterPull(origin.xyz, centre.xyz, pull, origin.w, vec2(centre.w, column.w));
}

/// Stores one; a macro, as GLSL passes no arrays of unknown size.
#define STORE_CLUSTER_PULL(pulls, c, values) \
    pulls[5u * c] = vec4((values).origin, (values).grip); \
    pulls[5u * c + 1u] = vec4((values).centre, (values).factors.x); \
    pulls[5u * c + 2u] = vec4((values).pull[0], (values).factors.y); \
    for (int column = 1; column < 3; ++column) pulls[5u * c + 2u + uint(column)] = vec4((values).pull[column], 0)

/// Stores that its particles stay.
#define STORE_NO_CHANGE(pulls, c) \
    pulls[5u * c + 1u].w = NO_CHANGE.x; \
    pulls[5u * c + 2u].w = NO_CHANGE.y
