#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "sim/base/files/output_file.h"
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

/// Changes and the steps before which they came, as lines of JSON that give the same bits again. The file gets its name
/// with finish().
class ChangeLog {
public:
    /// @param scene its name. @param world a hash of what is simulated.
    ChangeLog(const std::string& path, const std::string& scene, uint64_t world);
    void add(uint64_t step, const Change& change);
    void finish(uint64_t step, uint64_t stateHash);

private:
    OutputFile file_;
};

/// What such a file has.
struct LoggedChanges {
    struct Entry {
        uint64_t step = 0;
        Change change;
    };
    std::vector<Entry> changes;  ///< In their order, after the last reset.
    uint64_t steps = 0;          ///< At the end, after the last reset.
    std::string hash;            ///< Of the state there.
};

/// @param world of the scene that they are for. @throws InputError, one line, with the number of the faulty one.
LoggedChanges readChanges(const std::string& path, uint64_t world);

}  // namespace knuckle
