#pragma once

#include <string>

#include "app/json/json.h"
#include "sim/world/joint/joint.h"

namespace knuckle {

/// Reads the `limits` of a scene or a list of overrides, completed by its schema: converts degrees to radians, and a
/// stiffness of 0 to infinity.
JointLimits readLimits(const Json& json);
/// The same of an actor file: has the bits of what writeLimits() was given.
JointLimits readWrittenLimits(const Json& json);
/// Reads the `tearForce` and `tearTorque` of a joint, completed in the same way, and its `releaseTime` if it may have
/// one.
JointStrength readStrength(const Json& json);
/// Checks that each limit exists for some joint of these types. @throws InputError naming the first that does not.
void requireLimits(const std::string& path, const std::string& pointer, const JointLimits& limits,
                   const std::vector<JointType>& types);
/// The inverse of readWrittenLimits(), with all fields.
Json writeLimits(const JointLimits& limits);

}  // namespace knuckle
