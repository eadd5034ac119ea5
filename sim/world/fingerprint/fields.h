#pragma once

#include <tuple>

#include "sim/world/world.h"

/// Which fields of a World a run depends on.
namespace knuckle {

/// The fields of a struct that count. Each binding names all fields of its struct: it does not compile when one is
/// added, so that nobody forgets to decide whether that one counts.
template <typename... T>
auto counting(const T&... fields)
{
    return std::tie(fields...);
}

inline auto fieldsOf(const Settings& s)
{
    const auto& [solver, rotation, grid, reduction, order, gravity, timeStep, substeps, iterations, stabilization,
                 margin, freeze, virtualParticles, split, damping, maxSpeed, scaling, vorticity, sleepSpeed] = s;
    return counting(solver, rotation, grid, reduction, order, gravity, timeStep, substeps, iterations, stabilization,
                    margin, freeze, virtualParticles, split, damping, maxSpeed, scaling, vorticity, sleepSpeed);
}

inline auto fieldsOf(const Elasticity& e)
{
    const auto& [stiffness, poissonRatio, damping, yield, creep, maxDeformation] = e;
    return counting(stiffness, poissonRatio, damping, yield, creep, maxDeformation);
}

/// The points of foam are part of a state.
inline auto fieldsOf(const FluidLook& l)
{
    const auto& [drawn, absorption, scattering, foam, emission] = l;
    return counting(foam);
}

inline auto fieldsOf(const Material& m)
{
    const auto& [name, density, sticking, sliding, restitution, rolling, color, fluid, viscosity, slip, tension, look,
                 elasticity, finish] = m;
    return counting(density, sticking, sliding, restitution, rolling, fluid, viscosity, slip, tension, look,
                    elasticity);
}

inline auto fieldsOf(const SurfaceDistance& s)
{
    const auto& [distance, outward, ends] = s;
    return counting(distance, outward, ends);
}

inline auto fieldsOf(const Particle& p)
{
    const auto& [position, velocity, mass, material, body, bodyCount, assembly, rest, touches, margin, pinned, scale,
                 surface] = p;
    return counting(position, velocity, mass, material, body, bodyCount, assembly, rest, touches, margin, pinned, scale,
                    surface);
}

inline auto fieldsOf(const Link& l)
{
    const auto& [particle, body, restOffset, mass] = l;
    return counting(particle, body, restOffset, mass);
}

inline auto fieldsOf(const RoundShape& r)
{
    const auto& [radius, halfHeight] = r;
    return counting(radius, halfHeight);
}

inline auto fieldsOf(const Body& b)
{
    const auto& [name, motion, releaseTime, watched, absent, throwVelocity, throwSpin, material, assembly, linkStart,
                 linkCount, object, round, isCross, passed, mass, restCentre, position, rotation] = b;
    return counting(motion, releaseTime, watched, absent, throwVelocity, throwSpin, material, assembly, linkStart,
                    linkCount, object, round, isCross, passed, mass, restCentre, position, rotation);
}

inline auto fieldsOf(const Object& o)
{
    const auto& [name, bodyStart, bodyCount] = o;
    return counting(bodyStart, bodyCount);
}

inline auto fieldsOf(const Region& r)
{
    const auto& [shape, position, orientation, halfExtents, radius, halfHeight] = r;
    return counting(shape, position, orientation, halfExtents, radius, halfHeight);
}

inline auto fieldsOf(const Collider& c)
{
    // A binding cannot take a struct with a base.
    struct Own {
        decltype(c.grid) grid;
        decltype(c.staticFriction) sticking;
        decltype(c.kineticFriction) sliding;
        decltype(c.color) color;
        decltype(c.visible) visible;
        decltype(c.finish) finish;
        decltype(c.floor) floor;
    };
    static_assert(sizeof(Collider) <= sizeof(Region) + (sizeof(Own) + 15) / 16 * 16, "say whether a new field counts");
    return std::tuple_cat(fieldsOf(static_cast<const Region&>(c)),
                          counting(c.grid, c.staticFriction, c.kineticFriction));
}

inline auto fieldsOf(const Wind& w)
{
    const auto& [velocity, density, gusts, gustSize, seed] = w;
    return counting(velocity, density, gusts, gustSize, seed);
}

inline auto fieldsOf(const ForceField& f)
{
    const auto& [kind, falloff, region, strength, start, stop] = f;
    return counting(kind, falloff, region, strength, start, stop);
}

inline auto fieldsOf(const ColliderGrid& g)
{
    const auto& [low, cell, counts, values, vertices, triangles, drawnLow, drawnHigh] = g;
    return counting(low, cell, counts, values, drawnLow, drawnHigh);
}

inline auto fieldsOf(const Release& r)
{
    const auto& [cause, bodies, impulse, firstParticle, endParticle, driven, region] = r;
    return counting(cause, bodies, impulse, firstParticle, endParticle, driven, region);
}

inline auto fieldsOf(const TurnRange& r)
{
    const auto& [lowest, highest] = r;
    return counting(lowest, highest);
}

inline auto fieldsOf(const TurnLimits& l)
{
    const auto& [swing, twist, stiffness] = l;
    return counting(swing, twist, stiffness);
}

inline auto fieldsOf(const JointStrength& s)
{
    const auto& [force, torque, time] = s;
    return counting(force, torque, time);
}

inline auto fieldsOf(const JointSide& s)
{
    const auto& [arm, frame] = s;
    return counting(arm, frame);
}

inline auto fieldsOf(const TurnDrive& d)
{
    const auto& [stiffness, damping, angle, speed, greatestTorque, greatestSpeed] = d;
    return counting(stiffness, damping, angle, speed, greatestTorque, greatestSpeed);
}

inline auto fieldsOf(const Joint& j)
{
    const auto& [name, type, parent, child, particles, parentSide, childSide, limits, strength, turn, drive,
                 geared] = j;
    // The turn is that between both sides.
    return counting(type, parent, child, particles, parentSide, childSide, limits, strength, drive, geared);
}

inline auto fieldsOf(const Gear& g)
{
    const auto& [name, first, second, ratio] = g;
    return counting(first, second, ratio);
}

inline auto fieldsOf(const Pose& p)
{
    const auto& [translation, rotation] = p;
    return counting(translation, rotation);
}

inline auto fieldsOf(const BodyClip& c)
{
    const auto& [name, rate, bodyCount, roots, turns] = c;
    return counting(rate, bodyCount, roots, turns);
}

inline auto fieldsOf(const ClipPlay& p)
{
    const auto& [clip, at, start, speed, fade, loop, inPlace] = p;
    return counting(clip, at, start, speed, fade, loop, inPlace);
}

inline auto fieldsOf(const Animation& a)
{
    const auto& [object, pose, pivot, plays] = a;
    return counting(object, pose, pivot, plays);
}

inline auto fieldsOf(const ColliderMotion& m)
{
    const auto& [firstCollider, places, pose, play] = m;
    return counting(firstCollider, places, pose, play);
}

inline auto fieldsOf(const DriveSpring& s)
{
    const auto& [frequency, ratio, stiffness, damping, greatestTorque, greatestForce] = s;
    return counting(frequency, ratio, stiffness, damping, greatestTorque, greatestForce);
}

inline auto fieldsOf(const Pin& p)
{
    const auto& [body, spring] = p;
    return counting(body, spring);
}

inline auto fieldsOf(const StrengthKey& k)
{
    const auto& [time, value, smooth] = k;
    return counting(time, value, smooth);
}

inline auto fieldsOf(const HitReaction& h)
{
    const auto& [impulse, falloff, hold, recover] = h;
    return counting(impulse, falloff, hold, recover);
}

inline auto fieldsOf(const KnockOut& k)
{
    const auto& [distance, torqueTime] = k;
    return counting(distance, torqueTime);
}

inline auto fieldsOf(const Catch& c)
{
    const auto& [time, blend, near, within, otherwise, here, releaseTimes, limpTimes] = c;
    return counting(time, blend, near, within, otherwise, here, releaseTimes, limpTimes);
}

inline auto fieldsOf(const Puppet& p)
{
    const auto& [animation, joints, limpTimes, pins, strength, hit, knockOut, caught] = p;
    return counting(animation, joints, limpTimes, pins, strength, hit, knockOut, caught);
}

inline auto fieldsOf(const SoftBody& s)
{
    const auto& [name, material, object, assembly, rotation, particleStart, particleCount, clusterStart,
                 clusterCount] = s;
    return counting(material, object, assembly, rotation, particleStart, particleCount, clusterStart, clusterCount);
}

inline auto fieldsOf(const Cluster& c)
{
    const auto& [softBody, linkStart, linkCount] = c;
    return counting(softBody, linkStart, linkCount);
}

inline auto fieldsOf(const Strand& s)
{
    const auto& [kind, particles, restLengths, compliance, tearForce, startRelease, endRelease] = s;
    return counting(kind, particles, restLengths, compliance, tearForce, startRelease, endRelease);
}

inline auto fieldsOf(const Nozzle& n)
{
    const auto& [points, pitch, layerSpacing] = n;
    return counting(points, pitch, layerSpacing);
}

inline auto fieldsOf(const Emitter& e)
{
    const auto& [material, nozzle, velocity, start, stop, pool, takesOldest] = e;
    return counting(material, nozzle, velocity, start, stop, pool, takesOldest);
}

inline auto fieldsOf(const World& w)
{
    const auto& [radius, settings, materials, particles, bodies, links, joints, gears, objects, groups, clips,
                 animations, puppets, releases, colliders, motions, softBodies, clusters, clusterLinks, strands,
                 clothTriangles, grids, skins, shapes, drawn, unseen, assemblies, spacing, fluids, shown, emitters,
                 drains, wind, forceFields] = w;
    return counting(radius, settings, materials, particles, bodies, links, joints, gears, objects, clips, animations,
                    puppets, releases, colliders, motions, softBodies, clusters, clusterLinks, strands, clothTriangles,
                    grids, assemblies, spacing, fluids, emitters, drains, wind, forceFields);
}

}  // namespace knuckle
