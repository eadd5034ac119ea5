#pragma once

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// A builder with one material of that friction and restitution.
inline WorldBuilder builderOf(const Settings& settings, float friction, float restitution = 0.0f)
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.staticFriction = material.kineticFriction = friction;
    material.restitution = restitution;
    builder.addMaterial(material);
    return builder;
}

/// A smooth ball, or a capsule along the y axis of its pose. @returns its body's index.
inline uint32_t addRoundBody(WorldBuilder& builder, const RoundShape& round, const Pose& pose,
                             const Vector3f& velocity = {0, 0, 0}, const Vector3f& spin = {0, 0, 0},
                             uint32_t material = 0)
{
    const std::vector<Vector3f> places = round.halfHeight > 0.0f
                                             ? capsuleLattice(round.radius, round.halfHeight, DIAMETER)
                                             : sphereLattice(round.radius, DIAMETER);
    std::vector<SurfaceDistance> surface;
    for (const Vector3f& place : places) surface.push_back(capsuleSurface(place, round.radius, round.halfHeight));
    builder.beginObject("round");
    const uint32_t body = builder.addBody("round", places, material, Motion::Dynamic, surface, round);
    builder.endObject(pose, velocity, spin);
    return body;
}

}  // namespace knuckle::test
