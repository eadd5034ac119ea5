// One thread lists the drawn particles of its run, in order: points from the front of the list, quads after room for
// all particles, shadow casters after room for all once more; in each, fluids after room for all solids. No atomics:
// particles of equal depth must always have the same order.
#include "render/spheres/sphere_lists.glsl"
#include "render/spheres/sphere_runs.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer SphereDrawKinds { uint drawKinds[]; };
layout(std430) readonly buffer SphereCounts { uvec4 counts[]; };
layout(std430) writeonly buffer SphereList { uint list[]; };

void main()
{
    Run run = runAt(gl_GlobalInvocationID.x);
    if (run.begin >= run.end) return;
    uvec3 next = counts[gl_GlobalInvocationID.x].xyz + uvec3(0u, 1u, 2u) * frame.particleCount + run.first;
    for (uint i = run.begin; i < run.end; ++i) {
        uint how = drawKinds[i];
        if ((how & DRAWN_AS_POINT) != 0u) list[next.x] = i;
        if ((how & DRAWN_AS_QUAD) != 0u) list[next.y] = i;
        if ((how & CASTS_SHADOW) != 0u) list[next.z] = i;
        next += listCounts(how);
    }
}
