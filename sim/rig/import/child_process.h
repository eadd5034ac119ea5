#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace knuckle {

struct ChildLimits {
    uint64_t extraMemory = 2ull << 30;  ///< Address space beyond what the process uses now [bytes].
    int seconds = 60;                   ///< Processor time and wall-clock time each [s].
    uint64_t maxResult = 1ull << 30;    ///< [bytes]
};

struct ChildResult {
    bool ok = false;
    std::vector<uint8_t> bytes;  ///< What the work returned.
    std::string failure;         ///< Why there is no result: "crashed", "took more than 60 s", ...
};

/// Runs `work` in a forked copy of this process, with its output silenced, and returns its result through a pipe.
///
/// The child has one thread and copies of this process's locks. glibc makes malloc and stdio usable there, and `work`
/// must not touch anything else that another thread might hold (a GL context above all). @throws RunError if no
/// process or pipe can be had.
ChildResult runInChild(const std::function<std::vector<uint8_t>()>& work, const ChildLimits& limits);

}  // namespace knuckle
