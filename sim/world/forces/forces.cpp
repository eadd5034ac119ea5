#include "sim/world/forces/forces.h"

#include <algorithm>
#include <cmath>

#include "shared/force_types.h"
#include "sim/base/angles.h"
#include "sim/base/random.h"
#include "sim/world/forces/surroundings.h"
#include "sim/world/world.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr uint32_t WAVES = 16;
constexpr float SHORTEST = 1.0f / 12;  // shortest wave, over the longest

Vector3f direction(std::mt19937& random)
{
    const float z = 2.0f * uniformFraction(random) - 1.0f, turn = WHOLE_TURN * uniformFraction(random);
    const float flat = std::sqrt(std::max(1.0f - z * z, 0.0f));
    return {flat * std::cos(turn), flat * std::sin(turn), z};
}

float falloffAt(const ForceField& field, float distance)
{
    switch (field.falloff) {
        case FieldFalloff::None: return 1.0f;
        case FieldFalloff::Linear: return std::max(1.0f - distance / reachOf(field.region), 0.0f);
        case FieldFalloff::InverseSquare: break;
    }
    const float r = std::max(distance, static_cast<float>(FIELD_NEAREST));
    return 1.0f / (r * r);
}

}  // namespace

float reachOf(const Region& region)
{
    return region.shape == ColliderShape::Box ? region.halfExtents.norm() : region.radius;
}

Surroundings Surroundings::of(const World& world)
{
    const Settings& s = world.settings;
    const Vector3f wind = world.wind ? world.wind->velocity : Vector3f::Zero();
    return {s.gravity, wind, s.linearDamping, s.maxSpeed};
}

std::vector<GustWave> gustWaves(const Wind& wind)
{
    const float speed = wind.gusts * wind.velocity.norm();
    if (!(speed > 0.0f)) return {};
    std::mt19937 random(wind.seed);
    std::vector<GustWave> waves(WAVES);
    float squares = 0.0f;
    for (uint32_t i = 0; i < WAVES; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(WAVES - 1);
        const float length = wind.gustSize * std::pow(SHORTEST, part);
        GustWave& wave = waves[i];
        wave.wave = WHOLE_TURN / length * direction(random);
        Vector3f across = wave.wave.cross(direction(random));
        if (across.norm() < 1e-3f * wave.wave.norm()) across = wave.wave.unitOrthogonal();
        wave.amplitude = std::cbrt(length) * across.normalized();
        wave.phase = WHOLE_TURN * uniformFraction(random);
        wave.rate = speed * wave.wave.norm() * (uniformFraction(random) - 0.5f);
        squares += 0.5f * wave.amplitude.squaredNorm();
    }
    for (GustWave& wave : waves) wave.amplitude *= speed / std::sqrt(squares);
    return waves;
}

Vector3f airVelocity(const Wind& wind, const std::vector<GustWave>& waves, const Vector3f& place, float time)
{
    Vector3f velocity = wind.velocity;
    for (const GustWave& w : waves) {
        const float rate = w.rate - w.wave.dot(wind.velocity);
        velocity += std::cos(w.wave.dot(place) + rate * time + w.phase) * w.amplitude;
    }
    return velocity;
}

Vector3f fieldAt(const ForceField& field, const Vector3f& place)
{
    const Region& region = field.region;
    if (regionDistance(region, place) > 0.0f) return Vector3f::Zero();
    const Vector3f up = region.orientation * Vector3f::UnitY();
    if (region.shape == ColliderShape::Plane && field.kind != FieldKind::Swirl) {
        const float side = field.kind == FieldKind::Push ? -1.0f : 1.0f;
        return side * field.strength * up;
    }
    Vector3f from = place - region.position;
    const float along = from.dot(up);
    if (region.shape == ColliderShape::Capsule) from -= std::clamp(along, -region.halfHeight, region.halfHeight) * up;
    const float size = field.strength * falloffAt(field, from.norm());
    if (field.kind == FieldKind::Blow) return size * up;
    if (field.kind == FieldKind::Swirl) from = up.cross(place - region.position);
    const float length = from.norm();
    if (length < 1e-6f) return Vector3f::Zero();
    return (field.kind == FieldKind::Pull ? -size : size) / length * from;
}

}  // namespace knuckle
