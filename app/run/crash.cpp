#include "app/run/crash.h"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "render/files/leftovers.h"
#include "sim/world/memory.h"

namespace knuckle {

namespace {

constexpr int EXIT_CODE = 1;
std::string line;  // made before it is needed: there is no memory then

[[noreturn]] void end()
{
    clearLeftovers();
    const ssize_t ignored = write(STDERR_FILENO, line.data(), line.size());
    static_cast<void>(ignored);
    _exit(EXIT_CODE);
}

void onCrash(int signal)
{
    if (isMemoryShort()) end();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// What is thrown where nobody can catch it, as on a thread of a library.
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
    std::set_terminate(onTerminate);
    if (!addressSpaceLimit()) return;
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT}) std::signal(signal, onCrash);
}

}  // namespace knuckle
