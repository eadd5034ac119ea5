// One thread a cluster of a soft body: its strain, the length of (s1 - 1, s2 - 1, s3 - 1). The s are the principal
// stretches of the linear map nearest to its particles (Mueller et al. 2005): roots of eigenvalues of F^T F.
#include "render/common/frame.glsl"
#include "math/symmetric.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform usamplerBuffer shownClusters;    // first link, end
uniform samplerBuffer shownMoments;      // four each: inverse moments, empty directions
uniform samplerBuffer shownLinks;        // r [m]; w: mass [kg]
uniform usamplerBuffer shownLinked;      // particles of links
layout(std430) writeonly buffer ClusterStrains { float clusterStrains[]; };

const float THIRD_TURN = 2.09439510;

/// By the angle of the cubic (O. Smith 1961).
vec3 eigenvalues(mat3 m)
{
    vec3 beside = offDiagonalOf(m);
    float mean = traceOf(m) / 3.0;
    vec3 about = diagonalOf(m) - mean;
    float spread = sqrt((dot(about, about) + 2.0 * dot(beside, beside)) / 6.0);
    if (spread < 1e-7 * mean) return vec3(mean);
    float cosine = clamp(0.5 * determinant((m - mat3(mean)) / spread), -1.0, 1.0), angle = acos(cosine) / 3.0;
    return mean + 2.0 * spread * cos(vec3(angle, angle + THIRD_TURN, angle - THIRD_TURN));
}

mat3 moment(uint k)
{
    return symmetricMatrix(texelFetch(shownMoments, int(k)).xyz, texelFetch(shownMoments, int(k) + 1).xyz);
}

void main()
{
    uint c = gl_GlobalInvocationID.x;
    if (c >= uint(textureSize(shownClusters))) return;
    uvec2 links = texelFetch(shownClusters, int(c)).xy;
    vec3 origin = texelFetch(positions, int(texelFetch(shownLinked, int(links.x)).x)).xyz;
    mat3 sum = mat3(0.0);
    for (uint l = links.x; l < links.y; ++l) {
        vec4 link = texelFetch(shownLinks, int(l));
        vec3 arm = texelFetch(positions, int(texelFetch(shownLinked, int(l)).x)).xyz - origin;
        sum += outerProduct(link.w * arm, link.xyz);
    }
    mat3 map = sum * moment(4u * c);
    vec3 beyond = sqrt(max(eigenvalues(transpose(map) * map + moment(4u * c + 2u)), 0.0)) - 1.0;
    clusterStrains[c] = length(beyond);
}
