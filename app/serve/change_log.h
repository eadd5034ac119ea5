#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/serve/change.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// Changes and the steps before which they came, as lines of JSON that give the same bits again. Each line is in the file
/// as soon as it is added: it counts even if the program is killed.
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
    uint64_t steps = 0;          ///< At the end, or before the last change, after the last reset.
    std::string hash;            ///< Of the state there; empty: the end was not recorded.
};

/// @param world of the scene that they are for. @throws InputError, one line, with the number of the faulty one.
LoggedChanges readChanges(const std::string& path, uint64_t world);

}  // namespace knuckle
