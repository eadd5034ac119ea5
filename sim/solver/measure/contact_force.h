#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sim/base/no_index.h"

namespace knuckle {

/// A contact that pushes or rubs.
struct ContactForce {
    uint32_t particle = 0;
    uint32_t other = NO_INDEX;       ///< The second particle; NO_INDEX: a collider's.
    uint32_t collider = NO_INDEX;    ///< Index into World::colliders.
    Eigen::Vector3f force{0, 0, 0};  ///< On `particle` in the last substep, without what restitution gives [N].
    float normal = 0.0f;             ///< Its part across the contact, > 0 [N].
};

}  // namespace knuckle
