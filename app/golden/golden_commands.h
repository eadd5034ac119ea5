#pragma once

#include <string>
#include <vector>

#include "app/golden/golden_check.h"
#include "app/run/open_gpu.h"

namespace knuckle {

/// Which goldens a command is about.
struct GoldenChoice {
    std::string folder;              ///< Where all are.
    std::vector<std::string> names;  ///< Or patterns; empty: all.

    /// "DIR NAME...": the first word is the folder if there is one of that name, else the folder is `golden`.
    static GoldenChoice parse(const std::vector<std::string>& words);
};

/// All print to standard output, and return an exit code. @throws InputError, DeviceError, RunError, Interrupted.
int checkGoldens(const GoldenChoice& choice, const CheckOptions& options, bool json, const CommonOptions& common);

/// What to do where a golden has references of other drivers only.
enum class OtherDriver { Refuse, Beside, Replace };

struct UpdateOptions {
    OtherDriver otherDriver = OtherDriver::Refuse;
    bool all = false;                     ///< Also what has not failed.
    bool pictures = true, states = true;  ///< What is looked at; without states, pictures are drawn from those stored.
};
int updateGoldens(const GoldenChoice& choice, const UpdateOptions& options, const CommonOptions& common);

struct AddOptions {
    std::vector<std::string> inputs;  ///< A scene, or images.
    std::string folder = "golden";    ///< Where all are.
    std::string name;                 ///< Empty: that of the first input.
    std::string frames = "first,middle,last";
    std::string size;  ///< Empty: the default.
    std::vector<std::string> sets;
    std::string command;  ///< Of images.
};
int addGolden(const AddOptions& options, const CommonOptions& common);

struct SuggestOptions {
    unsigned repeats = 2;
    bool write = false;
};
int suggestLimits(const GoldenChoice& choice, const SuggestOptions& options, const CommonOptions& common);

}  // namespace knuckle
