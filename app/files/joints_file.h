#pragma once

#include <string>

#include "sim/actor/bodies/articulate.h"

namespace knuckle {

/// Reads joint overrides, schema assets/schema/joints.schema.json, into `options`. @throws InputError.
void readJoints(const std::string& path, ArticulationOptions& options);

}  // namespace knuckle
