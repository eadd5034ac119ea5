// One thread finds the bounds of every BOUNDS_THREADS-th particle.
#include "shared/frame_blocks.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430, binding = RENDER_POSITIONS_SLOT) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = RENDER_BOUNDS_SLOT) writeonly buffer Bounds { vec4 bounds[]; };

void main()
{
    uint thread = gl_GlobalInvocationID.x;
    vec3 low = vec3(1e30), high = vec3(-1e30);
    for (uint i = thread; i < frame.particleCount; i += BOUNDS_THREADS) {
        // What has left the lit stage must not stretch the shadow map.
        vec3 p = clamp(positions[i].xyz, frame.shadowLimitLow.xyz, frame.shadowLimitHigh.xyz);
        low = min(low, p);
        high = max(high, p);
    }
    bounds[2u * thread] = vec4(low, 0.0);
    bounds[2u * thread + 1u] = vec4(high, 0.0);
}
