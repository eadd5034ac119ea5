#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/solver/solver.h"

namespace knuckle {

enum class ChangeKind : uint32_t { Push, Throw, Stir, Release, Set, Reset };

/// What a viewer does to a simulation between two steps, without mouse and camera.
struct Change {
    ChangeKind kind = ChangeKind::Push;
    std::string name = {};  ///< Of a body, as "object" or "object/body"; Release: of an object, too; Stir: of
                            ///< what has no bodies; Set: of a LiveField.
    Eigen::Vector3f impulse{0, 0, 0};   ///< Push, Stir [N s].
    Eigen::Vector3f at{0, 0, 0};        ///< Push, Stir: where; Throw: from where [m].
    Eigen::Vector3f velocity{0, 0, 0};  ///< Throw [m/s].
    float radius = 0.0f;                ///< Stir: how far around it [m].
    std::vector<float> value = {};      ///< Set.
};

/// A Push, Throw, Stir or Release before the next step. After Solver::checkCounters().
/// @throws InputError, and changes nothing, for names that are not there and bodies that nothing moves.
void applyChange(Solver& solver, const World& world, const Change& change);

}  // namespace knuckle
