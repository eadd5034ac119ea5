#include "sim/world/fingerprint.h"

#include <bit>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

/// The fields of a struct that count. Each binding names all of its fields: it does not compile when one is added, so
/// that nobody forgets to say whether that one counts.
template <typename... T>
auto counting(const T&... fields)
{
    return std::tie(fields...);
}

auto fieldsOf(const Settings& s)
{
    const auto& [solver, rotation, grid, reduction, order, gravity, timeStep, substeps, iterations, stabilization,
                 margin, freeze, virtualParticles, split, damping, maxSpeed, scaling, vorticity, sleepSpeed] = s;
    return counting(solver, rotation, grid, reduction, order, gravity, timeStep, substeps, iterations, stabilization,
                    margin, freeze, virtualParticles, split, damping, maxSpeed, scaling, vorticity, sleepSpeed);
}

auto fieldsOf(const Elasticity& e)
{
    const auto& [stiffness, poissonRatio, damping, yield, creep, maxDeformation] = e;
    return counting(stiffness, poissonRatio, damping, yield, creep, maxDeformation);
}

auto fieldsOf(const Material& m)
{
    const auto& [name, density, sticking, sliding, restitution, rolling, color, fluid, viscosity, tension,
                 elasticity] = m;
    return counting(density, sticking, sliding, restitution, rolling, fluid, viscosity, tension, elasticity);
}

auto fieldsOf(const SurfaceDistance& s)
{
    const auto& [distance, outward, ends] = s;
    return counting(distance, outward, ends);
}

auto fieldsOf(const Particle& p)
{
    const auto& [position, velocity, mass, material, body, bodyCount, assembly, rest, touches, margin, pinned,
                 surface] = p;
    return counting(position, velocity, mass, material, body, bodyCount, assembly, rest, touches, margin, pinned,
                    surface);
}

auto fieldsOf(const Link& l)
{
    const auto& [particle, body, restOffset, mass] = l;
    return counting(particle, body, restOffset, mass);
}

auto fieldsOf(const RoundShape& r)
{
    const auto& [radius, halfHeight] = r;
    return counting(radius, halfHeight);
}

auto fieldsOf(const Body& b)
{
    const auto& [name, motion, releaseTime, watched, material, assembly, linkStart, linkCount, object, round, isCross,
                 passed, mass, restCentre, position, rotation] = b;
    return counting(motion, releaseTime, watched, material, assembly, linkStart, linkCount, object, round, isCross,
                    passed, mass, restCentre, position, rotation);
}

auto fieldsOf(const Object& o)
{
    const auto& [name, bodyStart, bodyCount] = o;
    return counting(bodyStart, bodyCount);
}

auto fieldsOf(const Collider& c)
{
    const auto& [shape, position, orientation, halfExtents, radius, halfHeight, grid, sticking, sliding, color,
                 visible] = c;
    return counting(shape, position, orientation, halfExtents, radius, halfHeight, grid, sticking, sliding);
}

auto fieldsOf(const ColliderGrid& g)
{
    const auto& [low, cell, counts, values, vertices, triangles, drawnLow, drawnHigh] = g;
    return counting(low, cell, counts, values, drawnLow, drawnHigh);
}

auto fieldsOf(const Release& r)
{
    const auto& [cause, bodies, impulse, firstParticle, endParticle, driven, region] = r;
    return counting(cause, bodies, impulse, firstParticle, endParticle, driven, region);
}

auto fieldsOf(const TurnRange& r)
{
    const auto& [lowest, highest] = r;
    return counting(lowest, highest);
}

auto fieldsOf(const TurnLimits& l)
{
    const auto& [swing, twist, stiffness] = l;
    return counting(swing, twist, stiffness);
}

auto fieldsOf(const JointStrength& s)
{
    const auto& [force, torque] = s;
    return counting(force, torque);
}

auto fieldsOf(const JointSide& s)
{
    const auto& [arm, frame] = s;
    return counting(arm, frame);
}

auto fieldsOf(const Joint& j)
{
    const auto& [name, type, parent, child, particles, parentSide, childSide, limits, strength] = j;
    return counting(type, parent, child, particles, parentSide, childSide, limits, strength);
}

auto fieldsOf(const Pose& p)
{
    const auto& [translation, rotation] = p;
    return counting(translation, rotation);
}

auto fieldsOf(const BodyClip& c)
{
    const auto& [name, rate, bodyCount, roots, turns] = c;
    return counting(rate, bodyCount, roots, turns);
}

auto fieldsOf(const ClipPlay& p)
{
    const auto& [clip, at, start, speed, fade, loop, inPlace] = p;
    return counting(clip, at, start, speed, fade, loop, inPlace);
}

auto fieldsOf(const Animation& a)
{
    const auto& [object, pose, pivot, plays] = a;
    return counting(object, pose, pivot, plays);
}

auto fieldsOf(const ColliderMotion& m)
{
    const auto& [firstCollider, places, pose, play] = m;
    return counting(firstCollider, places, pose, play);
}

auto fieldsOf(const DriveSpring& s)
{
    const auto& [frequency, ratio, stiffness, damping, greatestTorque, greatestForce] = s;
    return counting(frequency, ratio, stiffness, damping, greatestTorque, greatestForce);
}

auto fieldsOf(const Pin& p)
{
    const auto& [body, spring] = p;
    return counting(body, spring);
}

auto fieldsOf(const StrengthKey& k)
{
    const auto& [time, value, smooth] = k;
    return counting(time, value, smooth);
}

auto fieldsOf(const HitReaction& h)
{
    const auto& [impulse, falloff, hold, recover] = h;
    return counting(impulse, falloff, hold, recover);
}

auto fieldsOf(const KnockOut& k)
{
    const auto& [distance, torqueTime] = k;
    return counting(distance, torqueTime);
}

auto fieldsOf(const Catch& c)
{
    const auto& [time, blend, near, within, otherwise, here, releaseTimes, limpTimes] = c;
    return counting(time, blend, near, within, otherwise, here, releaseTimes, limpTimes);
}

auto fieldsOf(const Puppet& p)
{
    const auto& [animation, joints, limpTimes, pins, strength, hit, knockOut, caught] = p;
    return counting(animation, joints, limpTimes, pins, strength, hit, knockOut, caught);
}

auto fieldsOf(const SoftBody& s)
{
    const auto& [name, material, object, assembly, rotation, particleStart, particleCount, clusterStart,
                 clusterCount] = s;
    return counting(material, object, assembly, rotation, particleStart, particleCount, clusterStart, clusterCount);
}

auto fieldsOf(const Cluster& c)
{
    const auto& [softBody, linkStart, linkCount] = c;
    return counting(softBody, linkStart, linkCount);
}

auto fieldsOf(const Strand& s)
{
    const auto& [kind, particles, restLengths, compliance, tearForce] = s;
    return counting(kind, particles, restLengths, compliance, tearForce);
}

auto fieldsOf(const Nozzle& n)
{
    const auto& [points, pitch, layerSpacing] = n;
    return counting(points, pitch, layerSpacing);
}

auto fieldsOf(const Emitter& e)
{
    const auto& [material, nozzle, velocity, start, stop, pool, takesOldest] = e;
    return counting(material, nozzle, velocity, start, stop, pool, takesOldest);
}

auto fieldsOf(const World& w)
{
    const auto& [radius, settings, materials, particles, bodies, links, joints, objects, clips, animations, puppets,
                 releases, colliders, motions, softBodies, clusters, clusterLinks, strands, grids, skins, assemblies,
                 spacing, fluids, emitters, drains] = w;
    return counting(radius, settings, materials, particles, bodies, links, joints, objects, clips, animations, puppets,
                    releases, colliders, motions, softBodies, clusters, clusterLinks, strands, grids, assemblies,
                    spacing, fluids, emitters, drains);
}

class FieldHash {
public:
    template <typename T>
    void add(const T& value)
    {
        if constexpr (std::is_same_v<T, bool>) words_.add(static_cast<uint8_t>(value));
        else if constexpr (std::is_unsigned_v<T>) words_.add(value);
        else if constexpr (std::is_same_v<T, int>) words_.add(static_cast<uint32_t>(value));
        else if constexpr (std::is_same_v<T, float>) words_.add(std::bit_cast<uint32_t>(value));
        else if constexpr (std::is_same_v<T, double>) words_.add(std::bit_cast<uint64_t>(value));
        else if constexpr (std::is_enum_v<T>) add(static_cast<std::underlying_type_t<T>>(value));
        else std::apply([this](const auto&... fields) { (add(fields), ...); }, fieldsOf(value));
    }
    template <typename Scalar, int ROWS>
    void add(const Eigen::Matrix<Scalar, ROWS, 1>& vector)
    {
        for (const Scalar value : vector) add(value);
    }
    void add(const Quaternionf& rotation) { add(rotation.coeffs()); }
    /// With its length, so that what ends one list does not begin the next.
    template <typename T>
    void add(const std::vector<T>& list)
    {
        add(uint64_t{list.size()});
        for (const T& item : list) add(item);
    }
    template <typename T>
    void add(const std::optional<T>& item)
    {
        add(item.has_value());
        if (item) add(*item);
    }
    uint64_t value() const { return words_.value(); }

private:
    FnvHash words_;
};

}  // namespace

uint64_t fingerprint(const World& world)
{
    FieldHash hash;
    hash.add(world);
    return hash.value();
}

}  // namespace knuckle
