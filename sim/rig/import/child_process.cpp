#include "sim/rig/import/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <new>

#include "sim/base/errors.h"
#include "sim/base/memory.h"

namespace knuckle {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int EXIT_NO_MEMORY = 101;
constexpr int EXIT_EXCEPTION = 102;

/// @param beyond how far the hard limit is above the soft one, which only signals.
void limit(int resource, uint64_t value, uint64_t beyond = 0)
{
    rlimit current{};
    getrlimit(static_cast<__rlimit_resource_t>(resource), &current);
    const rlim_t wanted = std::min<rlim_t>(value, current.rlim_max);
    const rlimit lowered{wanted, std::min<rlim_t>(wanted + beyond, current.rlim_max)};
    setrlimit(static_cast<__rlimit_resource_t>(resource), &lowered);
}

void setLimits(const ChildLimits& limits, uint64_t addressSpace)
{
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, static_cast<uint64_t>(limits.seconds), 1);  // with equal limits it would be SIGKILL instead of
                                                                  // SIGXCPU
#if !defined(__SANITIZE_ADDRESS__)
    limit(RLIMIT_AS, addressSpace + limits.extraMemory);  // the sanitizer has already reserved terabytes
#else
    static_cast<void>(addressSpace);
#endif
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM, SIGPIPE}) {
        ::signal(signal, SIG_DFL);
    }
    const int nothing = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        dup2(nothing, stream);
    }
}

bool writeAll(int file, const void* data, size_t size)
{
    const auto* bytes = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = write(file, bytes, size);
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes += std::max<ssize_t>(written, 0);
        size -= static_cast<size_t>(std::max<ssize_t>(written, 0));
    }
    return true;
}

// Ends in _exit: destructors and exit handlers of the parent must not run twice.
[[noreturn]] void childMain(const std::function<std::vector<uint8_t>()>& work, const ChildLimits& limits,
                            uint64_t addressSpace, int pipe)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::set_new_handler(nullptr);
    setLimits(limits, addressSpace);
    int code = 0;
    try {
        const std::vector<uint8_t> bytes = work();
        const uint64_t size = bytes.size();
        code = writeAll(pipe, &size, sizeof size) && writeAll(pipe, bytes.data(), bytes.size()) ? 0 : EXIT_EXCEPTION;
    } catch (const std::bad_alloc&) {
        code = EXIT_NO_MEMORY;
    } catch (...) {
        code = EXIT_EXCEPTION;
    }
    _exit(code);
}

enum class Reading { Done, TooLate, TooMuch };

// Reads everything that the child writes until it closes the pipe.
Reading readAll(int pipe, const ChildLimits& limits, std::vector<uint8_t>& bytes)
{
    const auto deadline = Clock::now() + std::chrono::seconds(limits.seconds);
    std::vector<uint8_t> block(1 << 16);
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) {
            return Reading::TooLate;
        }
        pollfd ready{pipe, POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(left)) <= 0) {
            continue;
        }
        const ssize_t count = read(pipe, block.data(), block.size());
        if (count == 0) {
            return Reading::Done;
        }
        if (count > 0) {
            bytes.insert(bytes.end(), block.begin(), block.begin() + count);
        }
        if (bytes.size() > limits.maxResult + sizeof(uint64_t)) {
            return Reading::TooMuch;
        }
    }
}

std::string describe(int status, const ChildLimits& limits)
{
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
        return fmt::format("took more than {} s", limits.seconds);
    }
    if (WIFSIGNALED(status)) {
        return fmt::format("crashed ({})", strsignal(WTERMSIG(status)));
    }
    return WEXITSTATUS(status) == EXIT_NO_MEMORY
               ? fmt::format("wanted more than {} MiB of memory", limits.extraMemory >> 20)
               : "stopped before it was done";
}

}  // namespace

ChildResult runInChild(const std::function<std::vector<uint8_t>()>& work, const ChildLimits& limits)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        throw RunError(fmt::format("no pipe to a helper process: {}", std::strerror(errno)));
    }
    const uint64_t addressSpace = addressSpaceInUse();
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        childMain(work, limits, addressSpace, ends[1]);
    }
    close(ends[1]);
    if (child < 0) {
        close(ends[0]);
        throw RunError(fmt::format("no helper process: {}", std::strerror(errno)));
    }
    ChildResult result;
    const Reading reading = readAll(ends[0], limits, result.bytes);
    close(ends[0]);
    if (reading != Reading::Done) {
        kill(child, SIGKILL);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    uint64_t size = 0;
    if (reading == Reading::TooLate) {
        result.failure = fmt::format("took more than {} s", limits.seconds);
    } else if (reading == Reading::TooMuch) {
        result.failure = fmt::format("holds more than {} MiB", limits.maxResult >> 20);
    } else if (status != 0 || result.bytes.size() < sizeof size) {
        result.failure = describe(status, limits);
    } else {
        std::memcpy(&size, result.bytes.data(), sizeof size);
        result.bytes.erase(result.bytes.begin(), result.bytes.begin() + sizeof size);
        result.ok = size == result.bytes.size();
        result.failure = result.ok ? "" : "stopped before it was done";
    }
    return result;
}

}  // namespace knuckle
