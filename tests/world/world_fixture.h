#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "sim/base/errors.h"
#include "sim/world/builder/builder.h"
#include "sim/world/builder/parts/joints.h"
#include "tests/message_of.h"
#include "tests/pair_fixture.h"

namespace knuckle::test {

inline constexpr float DIAMETER = 0.1f;
/// Mass of a particle of the builder below: 1000 kg/m3 times the cube of the diameter [kg].
inline constexpr float PARTICLE_MASS = 1.0f;

/// A builder with one material at index 0.
inline WorldBuilder makeBuilder(const Settings& settings = {})
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.name = "clay";
    builder.addMaterial(material);
    return builder;
}

/// The lattice of a 3x3x3 cube about `centre` [diameters].
inline std::vector<Vector3f> cubeAt(const Vector3f& centre)
{
    std::vector<Vector3f> points = boxLattice({3, 3, 3}, DIAMETER);
    for (Vector3f& p : points) p += DIAMETER * centre;
    return points;
}

/// Two cubes along x with a free layer between them and a joint in its middle, the origin.
inline World jointedCubes(const JointSpec& spec, const Settings& settings = {}, Motion motionOfA = Motion::Dynamic)
{
    WorldBuilder builder = makeBuilder(settings);
    PairSpec pair;
    pair.joint = spec;
    pair.motionOfA = motionOfA;
    addJointedPair(builder, pair);
    return builder.build();
}

/// For errors that a user's file can cause.
template <typename Act>
std::string complaintOf(Act act)
{
    return messageOf<InputError>(act);
}

/// For errors that only wrong calls in code can cause.
template <typename Act>
std::string misuseOf(Act act)
{
    return messageOf<std::logic_error>(act);
}

}  // namespace knuckle::test
