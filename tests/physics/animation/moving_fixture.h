#pragma once

#include <functional>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// A clip of one body at the places of a function of the time [s], at 60 keys a second.
BodyClip motionOf(float seconds, const std::function<Pose(float)>& poseAt);
/// On a straight line at one speed [m/s].
BodyClip straightMotion(const Vector3f& velocity, float seconds);

/// A box that moves about its place, and stays where its clip ends.
void addMovingBox(WorldBuilder& builder, const Vector3f& place, const Vector3f& halfExtents, BodyClip clip);

}  // namespace knuckle::test
