// One thread finds the bounds and the moments of every BOUNDS_THREADS-th particle that is active and not unseen, and
// the bounds of those that the camera frames or looks at.
#include "render/common/sphere_sizes.glsl"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer Positions { vec4 positions[]; };
layout(std430) writeonly buffer ParticleBoxes { ParticleBounds bounds[]; };

#ifdef UNSEEN
layout(std430) readonly buffer UnseenParticles { uint unseenParticles[]; };   // a bit each
bool isUnseen(uint particle) { return (unseenParticles[particle >> 5] >> (particle & 31u) & 1u) != 0u; }
#else
bool isUnseen(uint particle) { return false; }
#endif
#ifdef FRAMED
layout(std430) readonly buffer FramedParticles { uint framedParticles[]; };   // a bit for each set of particles
bool isFramed(uint particle) { return (framedParticles[particle] & frame.framedBit) != 0u; }
bool isFocused(uint particle) { return (framedParticles[particle] & frame.focusBit) != 0u; }
#else
bool isFramed(uint particle) { return false; }
bool isFocused(uint particle) { return false; }
#endif

void main()
{
    uint thread = gl_GlobalInvocationID.x;
    vec3 low = vec3(1e30), high = vec3(-1e30), sum = vec3(0.0), squares = vec3(0.0);
    vec3 framedLow = low, framedHigh = high;
    vec4 framedMost = vec4(-1e30), framedLeast = vec4(1e30);
    vec3 focusLow = low, focusHigh = high;
    float count = 0.0;
    vec3 middle = 0.5 * (frame.shadowLimitLow.xyz + frame.shadowLimitHigh.xyz);
    for (uint i = thread; i < frame.particleCount; i += BOUNDS_THREADS) {
        vec3 p = positions[i].xyz;
        if (!isThere(positions[i])) continue;
        if (isFramed(i)) {
            framedLow = min(framedLow, p);
            framedHigh = max(framedHigh, p);
            vec4 across = vec4(p.x + p.y + p.z, p.y + p.z - p.x, p.x + p.z - p.y, p.x + p.y - p.z);
            framedMost = max(framedMost, across);
            framedLeast = min(framedLeast, across);
        }
        if (isFocused(i)) {
            focusLow = min(focusLow, p);
            focusHigh = max(focusHigh, p);
        }
        if (isUnseen(i)) continue;
        count += 1.0;
        low = min(low, p);
        high = max(high, p);
        sum += p - middle;
        squares += (p - middle) * (p - middle);
    }
    bounds[thread] = ParticleBounds(vec4(low, 0.0), vec4(high, 0.0), vec4(sum, count), vec4(squares, 0.0),
                                    vec4(framedLow, 0.0), vec4(framedHigh, 0.0), framedMost, framedLeast,
                                    vec4(focusLow, 0.0), vec4(focusHigh, 0.0));
}
