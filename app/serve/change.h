#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "sim/solver/solver.h"

namespace knuckle {

enum class ChangeKind : uint32_t { Push, Release, Reset };

/// What a viewer does to a simulation between two steps, without mouse and camera.
struct Change {
    ChangeKind kind = ChangeKind::Push;
    std::string name = {};             ///< Of a body, as "object" or "object/body"; Release: of an object, too.
    Eigen::Vector3f impulse{0, 0, 0};  ///< Push [N s].
    Eigen::Vector3f at{0, 0, 0};       ///< Push: where [m].
};

/// Changes the state before the next step; a Reset is the caller's. After Solver::checkCounters().
/// @throws InputError, and changes nothing, for names that are not there and bodies that nothing moves.
void applyChange(Solver& solver, const World& world, const Change& change);

}  // namespace knuckle
