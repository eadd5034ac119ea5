#pragma once

#include <string>

#include "app/json/json.h"
#include "sim/world/joint/joint.h"

namespace knuckle {

/// The `limits` of a scene, an actor or a list of overrides, completed by its schema: degrees become radians, a
/// stiffness of 0 infinite.
JointLimits readLimits(const Json& json);
/// The `tearForce` and `tearTorque` of a joint, completed in the same way.
JointStrength readStrength(const Json& json);
/// That each limit is one of some joint of these types. @throws InputError naming the first that is not.
void requireLimits(const std::string& path, const std::string& pointer, const JointLimits& limits,
                   const std::vector<JointType>& types);
/// The way back, with all fields.
Json writeLimits(const JointLimits& limits);

}  // namespace knuckle
