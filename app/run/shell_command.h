#pragma once

#include <string>
#include <vector>

namespace knuckle {

/// How a command of the user's shell ended.
struct ShellResult {
    std::string failure = {};   ///< Empty: it succeeded; else "failed with exit code 3", "was ended by signal 9".
    std::string output = {};    ///< All that it wrote.
    std::string lastLine = {};  ///< Of that.
};

/// The last line of what a program wrote, shortened; empty if it has none.
std::string lastLineOf(const std::string& text);

/// How a program ended, by waitpid()'s status: "failed with exit code 3", "was ended by signal 9"; empty: it succeeded.
std::string failureOf(int status);

/// A word as the shell reads it back.
std::string quotedForShell(const std::string& word);

/// Runs a line in /bin/sh and waits for it. @param folder in which it runs. @param environment "NAME=value", in
/// place of the program's own. @throws InputError if it cannot be started.
ShellResult runShell(const std::string& line, const std::string& folder,
                     const std::vector<std::string>& environment = {});

}  // namespace knuckle
