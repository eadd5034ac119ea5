#include "app/run/crash.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "sim/base/files/leftovers.h"
#include "sim/base/memory.h"

namespace knuckle {

namespace {

constexpr int EXIT_CODE = 1;
std::string line;  // made in advance: when needed, there is no memory

[[noreturn]] void end()
{
    static std::atomic<bool> begun = false;
    thread_local bool here = false;
    if (here) _exit(EXIT_CODE);  // what follows has failed, too
    if (begun.exchange(true))
        for (;;) pause();  // another thread tells it, and ends this one
    here = true;
    clearLeftovers();
    const ssize_t ignored = write(fileno(stderr), line.data(), line.size());
    static_cast<void>(ignored);
    _exit(EXIT_CODE);
}

void onCrash(int signal)
{
    if (isMemoryShort()) end();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Silences LLVM and glibc, which repeat at a crash what our one line says.
void silenceLibraries()
{
    const int own = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    FILE* file = own >= 0 ? fdopen(own, "w") : nullptr;
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (file == nullptr || nothing < 0) return;
    std::setvbuf(file, nullptr, _IONBF, 0);
    stderr = file;
    dup2(nothing, STDERR_FILENO);
    close(nothing);
}

/// Handles exceptions that nothing can catch, such as on a library's thread.
void onTerminate()
{
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
        end();
    } catch (...) {
    }
    std::abort();
}

}  // namespace

void tellCrashesForWantOfMemory()
{
    line = "knuckle: " + memoryMessage() + "\n";
    // Ends directly, instead of unwinding through a driver that would wait forever.
    std::set_new_handler(end);
    std::set_terminate(onTerminate);
    if (!addressSpaceLimit()) return;
    silenceLibraries();
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT}) std::signal(signal, onCrash);
}

}  // namespace knuckle
