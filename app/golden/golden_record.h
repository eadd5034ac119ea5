#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/golden/golden_file.h"
#include "app/run/interrupt.h"
#include "sim/gpu/gpu.h"

namespace knuckle {

/// What of a golden is made anew.
struct RecordWork {
    std::string key = {};  ///< Of the references; "" for those of another program.
    bool made = false;     ///< Another program's pictures were made just now.
    bool states = true;    ///< Simulates, and writes the states; otherwise pictures are drawn from those there.
    std::set<uint64_t> frames = {};     ///< Whose pictures are written.
    std::set<std::string> images = {};  ///< Of another program: stems of those that are taken over.
};

/// All of it.
RecordWork wholeWork(const Golden& golden, const std::string& key);

/// Makes references, writes them and then golden.json. @param gpu of this thread; null for another program's pictures.
/// @returns names of the files that were written. @throws InputError, RunError, Interrupted.
std::vector<std::string> recordGolden(Golden& golden, const RecordWork& work, Gpu* gpu,
                                      const InterruptGuard& interrupt);

}  // namespace knuckle
