#pragma once

#include <functional>
#include <string>
#include <vector>

namespace knuckle::test {

struct RunOptions {
    std::string folder = {};                    ///< Working folder; empty: this one's.
    std::vector<std::string> environment = {};  ///< "NAME=value", replacing inherited values.
    std::function<void()> inChild = {};         ///< Runs before the program starts: limits, user.
    std::string standardOutput = {};            ///< Empty: captured; else a file, such as /dev/full.
    int signalAfterFile = 0;                    ///< Sends this signal as soon as `waitFor` exists.
    std::string waitFor = {};
    bool signalTwice = false;  ///< And once more 0.3 s later.
};

struct RunResult {
    int code = -1;  ///< Exit code, or 1000 + signal for a crash.
    std::string out, err;
};

/// Runs the built program as a user would and waits for it.
RunResult runKnuckle(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Whether `text` is one line, ended by a newline.
bool isOneLine(const std::string& text);
/// Every path below a folder, sorted, relative to it.
std::vector<std::string> listFolder(const std::string& folder);

}  // namespace knuckle::test
