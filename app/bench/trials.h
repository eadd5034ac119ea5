#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// What `bench compare` measures of a program: a short benchmark, or a start.
struct Trial {
    std::string name;
    std::string what;  ///< For people, of milliseconds: "a step of 100 pairs".
    std::vector<std::string> arguments;
    /// Keys of the benchmark's JSON whose sum is the time [ms]; where there is only a rate [1/s], it alone. None: the
    /// time of the whole program by the clock.
    std::vector<std::string> milliseconds = {};
    std::string rate = {};
    bool emptyCache = false;  ///< Drivers find no compiled shaders.
    bool byDefault = false;
};

const std::vector<Trial>& trials();

/// A folder with all that programs write while they are measured, removed with everything in it.
class TrialFolder {
public:
    /// @throws RunError where none can be made.
    TrialFolder();
    ~TrialFolder();
    TrialFolder(const TrialFolder&) = delete;
    TrialFolder& operator=(const TrialFolder&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

/// Runs a program once. @param device its `--device`. @param folder of its own, whose cache of shaders it finds again.
/// @returns milliseconds. @throws RunError, with the last line that it said, if it fails, or prints no such figures.
double runTrial(const Trial& trial, const std::string& program, const std::string& device, const std::string& folder);

}  // namespace knuckle
