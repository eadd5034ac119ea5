// One thread a point: moves it for a step. Where little fluid is around, it is spray and flies; where some is, foam
// that goes with it; in its middle, a bubble that rises.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/colliders.glsl"
#include "sim/fluid/foam/foam_points.glsl"
#include "sim/fluid/foam/foam_around.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer foamRing;
FLOAT_TEXELS(foamPlaces)
FLOAT_TEXELS(foamMoves)

// Share of fluid around it up to which a point is spray, and from which it is a bubble.
const float SPRAY = 0.12, BUBBLE = 0.85;
// Times in which drag takes all but 1/e: of the air from spray, of the fluid from a bubble [s].
const float AIR_DRAG = 0.7, FLUID_DRAG = 0.1;
// Speed at which bubbles rise, in foamSpeed().
const float RISE = 0.5;
// How much faster spray ages that lies on something, and bubbles, which are not yet at the surface, do.
const float LYING = 4.0, BELOW = 0.5;
// In which points appear, and vanish [s].
const float APPEARS = 0.06, VANISHES = 0.5;

/// Through the air, by drag proportional to its speed against it.
FoamPoint flown(FoamPoint p, float h)
{
    float kept = exp(-h / AIR_DRAG), way = AIR_DRAG * (1.0 - kept);
    vec3 end = sim.wind.xyz + AIR_DRAG * sim.gravity.xyz;
    p.position += h * end + way * (p.velocity - end);
    p.velocity = end + kept * (p.velocity - end);
    return p;
}

FoamPoint floated(FoamPoint p, FluidAround fluid, float h)
{
    vec3 before = p.velocity;
    vec3 rise = -RISE * foamSpeed() * sim.gravity.xyz / max(length(sim.gravity.xyz), 1e-20);
    vec3 end = fluid.velocity + rise;
    p.velocity = fluid.share > BUBBLE ? end + exp(-h / FLUID_DRAG) * (before - end) : fluid.velocity;
    p.position += 0.5 * h * (before + p.velocity);
    return p;
}

/// Keeps it out of colliders. @returns whether it touches one.
bool stopped(inout FoamPoint p)
{
    bool touches = false;
    float gap = 0.1 * sim.fluidSpacing;
    for (uint c = 0u; c < sim.colliderCount; ++c) {
        ColliderSurface wall = colliderSurface(c, p.position);
        bool inside = wall.distance < gap;
        p.position += inside ? (gap - wall.distance) * wall.normal : vec3(0);
        p.velocity -= inside ? min(dot(p.velocity, wall.normal), 0.0) * wall.normal : vec3(0);
        touches = touches || inside;
    }
    return touches;
}

void main()
{
    uint n = gl_GlobalInvocationID.x;
    RingState ring = ringStateOf(texelFetch(foamRing, FOAM_RING));
    if (n >= ring.used) return;
    vec4 place = imageLoad(foamPlaces, int(n)), move = imageLoad(foamMoves, int(n));
    if (move.w <= 0.0) return;
    float h = stepTime();
    FoamPoint before = FoamPoint(place.xyz, place.w, move.xyz, move.w), p = flown(before, h);
    FluidAround fluid = fluidAround(p.position, 0.5 * (before.position + p.position));
    bool sprays = fluid.share < SPRAY;
    if (!sprays) p = floated(before, fluid, h);
    bool lies = stopped(p) && sprays;
    p.velocity *= lies ? 0.8 : 1.0;
    p.life = max(p.life - h * (lies ? LYING : fluid.share > BUBBLE ? BELOW : 1.0), 0.0);
    // Slots that soon get others fade as well.
    float left = float((n + sim.foamCapacity - ring.head) % sim.foamCapacity) / (0.125 * float(sim.foamCapacity));
    float most = min(min(p.life / VANISHES, left), 1.0);
    p.opacity = min(p.opacity + (1.0 - exp(-h / APPEARS)), most);
    imageStore(foamPlaces, int(n), vec4(p.position, p.opacity));
    imageStore(foamMoves, int(n), vec4(p.velocity, p.life));
}
