#include "app/sweep/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "sim/base/errors.h"
#include "sim/base/files/file_descriptor.h"

namespace knuckle {

namespace {

/// In the child, where only what is safe after fork() may be done. Never returns.
[[noreturn]] void become(char** words, int log, pid_t parent)
{
    constexpr int NOT_STARTED = 127;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(NOT_STARTED);  // it has ended before
    setpgid(0, 0);
    std::signal(SIGPIPE, SIG_DFL);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execv("/proc/self/exe", words);
    _exit(NOT_STARTED);
}

}  // namespace

std::string ownProgram()
{
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

pid_t startChild(const std::vector<std::string>& words, const std::string& log)
{
    const FileDescriptor file(open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (file.get() < 0) throw RunError(fmt::format("{} cannot be written: {}", log, std::strerror(errno)));
    std::vector<std::string> own = words;
    std::vector<char*> pointers;
    for (std::string& word : own) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t parent = getpid(), child = fork();
    if (child == 0) become(pointers.data(), file.get(), parent);
    if (child < 0) throw RunError(fmt::format("{} cannot be started: {}", words[0], std::strerror(errno)));
    return child;
}

void stopChild(pid_t child)
{
    sigqueue(child, SIGTERM, sigval{});
}

}  // namespace knuckle
