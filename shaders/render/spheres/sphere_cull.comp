// One thread decides how the particles of a run are drawn, and counts them: as points, as quads (if too large for the
// driver's points, or with a clipped centre), as shadow casters, or not at all.
#include "render/spheres/burial.glsl"
#include "render/spheres/covered.glsl"
#include "render/common/drawn_radius.glsl"
#include "render/common/sphere_bounds.glsl"
#include "render/spheres/sphere_lists.glsl"
#include "render/spheres/sphere_runs.glsl"
#include "math/spheroid.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
uniform samplerBuffer positions;
layout(std430) writeonly buffer SphereDrawKinds { uint drawKinds[]; };
layout(std430) writeonly buffer SphereCounts { uvec4 counts[]; };
layout(std430) readonly buffer BurialCells { uint cells[]; };
#ifdef SURFACES
uniform usamplerBuffer fluidMaterials, fluidForms;

/// Whether it is a part of a surface of fluid that others of it hide.
bool isWithinFluid(uint particle)
{
    return particle >= frame.solidCount && texelFetch(fluidForms, int(particle)).x == INNER &&
           texelFetch(fluidMaterials, int(particle - frame.solidCount)).x != NO_SURFACE;
}
#else
bool isWithinFluid(uint particle) { return false; }
#endif

uint howDrawn(vec3 position, float radius)
{
    vec3 centre = toView(position);
    vec2 size = vec2(frame.width, frame.height);
    vec4 bounds = sphereBounds(centre, radius, vec2(size.y / size.x, 1.0) / frame.tanHalfFov);
    // An eye inside the sphere sees through it.
    bool inFront = centre.z < radius && dot(centre, centre) > radius * radius;
    bool inside = all(lessThan(bounds.xy, vec2(1.0))) && all(greaterThan(bounds.zw, vec2(-1.0)));
    vec2 extent = 0.5 * (bounds.zw - bounds.xy) * size;
    vec2 middle = 0.5 * (bounds.xy + bounds.zw);
    bool asPoint = max(extent.x, extent.y) + 1.0 <= frame.pointSizeLimit && all(lessThan(abs(middle), vec2(1.0))) &&
                   -centre.z > 1.01 * radius;
    uint hidden = cells[burialCell(position)];
    bool seen = inFront && inside && (hidden & HIDDEN_FROM_EYE) == 0u;
    uint how = !seen ? 0u : asPoint ? DRAWN_AS_POINT : DRAWN_AS_QUAD;
    return how | ((hidden & HIDDEN_FROM_LIGHT) == 0u ? CASTS_SHADOW : 0u);
}

void main()
{
    Run run = runAt(gl_GlobalInvocationID.x);
    if (run.begin >= run.end) return;
    uvec3 count = uvec3(0u);
    for (uint i = run.begin; i < run.end; ++i) {
        vec4 position = texelFetch(positions, int(i));
        bool shown = isShown(i, position) && !isWithinFluid(i);
        uint how = shown ? howDrawn(position.xyz, drawnRadius(i)) : 0u;
        drawKinds[i] = how;
        count += listCounts(how);
    }
    counts[gl_GlobalInvocationID.x] = uvec4(count, 0u);
}
