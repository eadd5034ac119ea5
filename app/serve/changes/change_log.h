#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/serve/changes/change.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Changes and the steps before which they came, as lines of JSON that give the same bits again. Each line is in the
/// file as soon as it is added: it counts even if the program is killed.
class ChangeLog {
public:
    /// @param scene its name. @param world a hash of what is simulated.
    ChangeLog(const std::string& path, const std::string& scene, uint64_t world);
    void add(uint64_t step, const Change& change);
    /// From here on another world. @param sets all changes of the scene on top of those of the command line.
    void restart(uint64_t step, const std::vector<std::string>& sets, uint64_t world);
    void finish(uint64_t step, uint64_t stateHash);

private:
    OutputFile file_;
};

/// What such a file has, after its last restart and reset.
struct LoggedChanges {
    struct Entry {
        uint64_t step = 0;
        Change change;
    };
    std::string scene, world;         ///< Its name, and a hash.
    std::vector<std::string> sets;    ///< As of ChangeLog::restart().
    std::vector<Entry> changes = {};  ///< In their order.
    uint64_t steps = 0;               ///< At the end, or before the last change.
    std::string hash = {};            ///< Of the state there; empty: the end was not recorded.
};

/// @throws InputError, one line, with the number of the faulty one.
LoggedChanges readChanges(const std::string& path);

}  // namespace knuckle
