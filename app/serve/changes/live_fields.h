#pragma once

#include <string>
#include <vector>

#include "sim/solver/solver.h"

namespace knuckle {

/// A setting that may change between two steps of one simulation.
struct LiveField {
    std::string name;                 ///< "gravity", "motor mill/axle"
    std::vector<float> value;         ///< One number, or three.
    float least = 0.0f, most = 0.0f;  ///< Of each.
    std::string unit;
    uint32_t joint = NO_INDEX;  ///< Of a motor.
};

/// Those of a world, and what they are now.
class LiveFields {
public:
    explicit LiveFields(const World& world);

    const std::vector<LiveField>& all() const { return fields_; }
    /// From the next step on. After Solver::checkCounters(). @throws InputError, one line, for what is not there, may
    /// not change, or is out of range; nothing changes then.
    void set(Solver& solver, const std::string& name, const std::vector<float>& value);
    /// As the world begins: for a solver that has gone back there.
    void reset();

private:
    const LiveField& check(const std::string& name, const std::vector<float>& value) const;

    const World& world_;
    Surroundings surroundings_;
    std::vector<LiveField> fields_;
};

}  // namespace knuckle
