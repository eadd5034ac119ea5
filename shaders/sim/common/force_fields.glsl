// Wind and force fields at a place and a time, as sim/world/forces/forces.h has them.
#include "math/quaternion.glsl"
#include "shared/force_types.h"

READ_BUFFER(ForceField, ForceFields, forceFields);
READ_BUFFER(GustWave, GustWaves, gustWaves);
READ_BUFFER(Counters, CountersBlock, counters);

/// When the substep begins [s].
float timeNow()
{
    return float(counters[0].substep) * sim.substepTime;
}

bool isInside(ForceField field, vec3 p)
{
    if (field.kind.x == COLLIDER_PLANE) return p.y <= 0.0;
    if (field.kind.x == COLLIDER_BOX) return all(lessThanEqual(abs(p), field.size.xyz));
    float halfHeight = field.kind.x == COLLIDER_CAPSULE ? field.size.y : 0.0;
    return length(p - vec3(0, clamp(p.y, -halfHeight, halfHeight), 0)) <= field.size.x;
}

float falloffAt(ForceField field, float distance)
{
    if (field.kind.z == FALLOFF_NONE) return 1.0;
    if (field.kind.z == FALLOFF_LINEAR) return max(1.0 - distance / field.size.w, 0.0);
    float r = max(distance, FIELD_NEAREST);
    return 1.0 / (r * r);
}

/// What a field adds while it acts: an acceleration [m/s2], or for FIELD_BLOW a velocity of the air [m/s].
vec3 fieldAt(ForceField field, vec3 x)
{
    vec3 from = rotate(conjugate(field.turn), x - field.place.xyz);
    if (!isInside(field, from)) return vec3(0);
    float strength = field.place.w;
    vec3 local;
    if (field.kind.x == COLLIDER_PLANE && field.kind.y != FIELD_SWIRL) {
        local = vec3(0, field.kind.y == FIELD_PUSH ? -strength : strength, 0);
    } else {
        vec3 about = vec3(from.z, 0, -from.x);   // y across from
        if (field.kind.x == COLLIDER_CAPSULE) from.y -= clamp(from.y, -field.size.y, field.size.y);
        strength *= falloffAt(field, length(from));
        if (field.kind.y == FIELD_SWIRL) from = about;
        if (field.kind.y == FIELD_PULL) from = -from;
        float size = length(from);
        if (field.kind.y == FIELD_BLOW) local = vec3(0, strength, 0);
        else local = size < 1e-6 ? vec3(0) : strength / size * from;
    }
    return rotate(field.turn, local);
}

/// All fields: their acceleration, and the velocity that they give to the air.
struct FieldSum {
    vec3 acceleration, blown;
};

FieldSum fieldsAt(vec3 x)
{
    FieldSum sum = FieldSum(vec3(0), vec3(0));
    float now = timeNow();
    for (uint f = 0u; f < sim.forceFieldCount; ++f) {
        ForceField field = forceFields[f];
        if (now < field.times.x || now >= field.times.y) continue;
        vec3 added = fieldAt(field, x);
        if (field.kind.y == FIELD_BLOW) sum.blown += added;
        else sum.acceleration += added;
    }
    return sum;
}

/// The air's velocity without fields that blow [m/s].
vec3 airVelocity(vec3 x)
{
    vec3 velocity = sim.wind.xyz;
    float now = timeNow();
    for (uint w = 0u; w < sim.gustWaveCount; ++w) {
        GustWave wave = gustWaves[w];
        velocity += cos(dot(wave.wave.xyz, x) + wave.amplitude.w * now + wave.wave.w) * wave.amplitude.xyz;
    }
    return velocity;
}

/// Drag that makes nothing faster than the air in a substep. @param wind past it [m/s].
/// @param drag half of density, drag coefficient and area over mass, along the same axes [1/m].
vec3 dragAcceleration(vec3 wind, vec3 drag)
{
    vec3 rate = length(wind) * drag;
    return rate * wind / (1.0 + sim.substepTime * rate);
}
