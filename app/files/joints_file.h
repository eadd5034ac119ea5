#pragma once

#include <string>

#include "sim/rig/actor_options.h"

namespace knuckle {

/// Reads joint overrides, schema assets/schema/joints.schema.json, into `options`. @throws InputError.
void readJoints(const std::string& path, ArticulationOptions& options);

}  // namespace knuckle
