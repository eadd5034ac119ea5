#include "tests/cli/run_program.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle::test {

namespace {

[[noreturn]] void startProgram(const std::vector<std::string>& arguments, const RunOptions& options,
                               const std::string& out, const std::string& err)
{
    std::vector<char*> words{const_cast<char*>(programPath().c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(125);
    for (const std::string& variable : options.environment) putenv(const_cast<char*>(variable.c_str()));
    if (options.inChild) options.inChild();
    execv(words[0], words.data());
    _exit(126);
}

/// Waits until the file exists. @returns false if the child has ended before.
bool waitForFile(pid_t child, const std::string& path)
{
    while (!std::filesystem::exists(path)) {
        siginfo_t info = {};
        waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
        if (info.si_pid != 0) return false;
        sched_yield();
    }
    return true;
}

}  // namespace

RunResult runKnuckle(const std::vector<std::string>& arguments, const RunOptions& options)
{
    const TempFolder folder;
    const std::string out = options.standardOutput.empty() ? folder.path("out") : options.standardOutput;
    const std::string err = folder.path("err");
    const pid_t child = fork();
    if (child == 0) startProgram(arguments, options, out, err);
    if (options.signalAfterFile != 0 && waitForFile(child, options.waitFor)) kill(child, options.signalAfterFile);
    if (options.signalTwice) {
        usleep(300000);
        kill(child, options.signalAfterFile);
    }
    int status = 0;
    waitpid(child, &status, 0);
    RunResult result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    if (options.standardOutput.empty()) result.out = readText(out);
    result.err = readText(err);
    return result;
}

bool isOneLine(const std::string& text)
{
    return !text.empty() && text.find('\n') == text.size() - 1;
}

std::vector<std::string> listFolder(const std::string& folder)
{
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        paths.push_back(std::filesystem::relative(entry.path(), folder).string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace knuckle::test
