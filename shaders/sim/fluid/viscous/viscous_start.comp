// One thread a slot, after pressures: what the solve of viscosity starts from.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/collider_moves.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/viscous/viscous_materials.glsl"
#include "sim/fluid/viscous/viscous_slots.glsl"
#include "sim/fluid/viscous/viscous_pairs.glsl"
#include "sim/fluid/walls/fluid_colliders.glsl"

layout(local_size_x = GROUP_SIZE) in;
// No texture of this: colliders need many.
READ_BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, SlotGoals, newSlotGoals);
BUFFER(vec4, SlotGrips, newSlotGrips);
BUFFER(vec4, SlotFlows, newSlotFlows);

// Between fluid at its thinnest and at its densest, the sum of shears over that of fluid at rest. At a surface it is
// smaller, since less is sheared there.
const vec2 SHEARS = vec2(0.67, 1.25);

/// The collider that holds a particle hardest: walls that coincide count once.
SlotGrip gripOf(uint k, vec3 x, ViscousMaterial material)
{
    SlotGrip grip = SlotGrip(vec3(0), 0.0);
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        // Particles stand in a layer at the wall, and the next is further away: the wall counts as nearer.
        float z = max(colliderSurface(near.index, x).distance, 0.35 * sim.fluidSpacing);
        float depth = material.slip - 0.2 * sim.fluidSpacing;
        float shear = material.wallGrip * wallShear(z, depth);
        if (shear > grip.grip) grip = SlotGrip(surfaceMove(near.index, x) / sim.substepTime, shear);
    }
    return grip;
}

/// The velocity of a particle that has just left a nozzle: viscous fluid that follows, which no particles stand for,
/// holds it as the nozzle does. If it fell freely, threads would come apart there.
vec3 heldVelocity(vec3 velocity, ViscousMaterial material)
{
    return isViscous(material) ? velocity - sim.substepTime * sim.gravity.xyz : velocity;
}

/// The sum of a^3 r^4 over its neighbours, over that of a fluid without surfaces. Particles stand in layers at
/// walls, and further apart where no pressure holds them together: taken as they are, they would slide past each
/// other too easily.
float shearsAround(uint k, vec3 x)
{
    float sum = 0.0, inverseReach = 1.0 / sim.fluidReach;
    uint count = fetchCounts(k).fluids;
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) {
            vec3 r = x - fetchSlotStart(slots[c]).position;
            float squared = dot(r, r);
            sum += fluidShear(squared, inverseReach) * squared * squared;
        }
    } while (nextTexel(texels));
    float reach2 = sim.fluidReach * sim.fluidReach;
    return sum / (0.01496 * reach2 * reach2 * pow(sim.fluidReach / sim.fluidSpacing, 3.0));
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    SlotGrip grip = SlotGrip(vec3(0), 0.0);
    SlotGoal goal = goalOf(newSlotGoals[k]);
    float thickness = 0.0;
    if (isFluid(i)) {
        ViscousMaterial material = fetchViscousMaterial(fetchParticle(i).material);
        FluidVelocity own = fluidVelocity(velocities[i]);
        goal = SlotGoal(own.velocity, fetchMass(i).inverseMass);
        if (own.timeHeld > 0.0) goal = SlotGoal(heldVelocity(own.velocity, material), 0.0);
        newSlotGoals[k] = pack(goal);
        vec3 x = fetchSlotStart(k).position;
        grip = gripOf(k, x, material);
        thickness = material.thickness / clamp(shearsAround(k, x), SHEARS.x, SHEARS.y);
    }
    newSlotGrips[k] = pack(grip);
    newSlotFlows[k] = pack(SlotFlow(goal.velocity, thickness));
}
