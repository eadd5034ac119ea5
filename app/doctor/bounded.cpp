#include "app/doctor/bounded.h"

#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <vector>

#include "sim/base/files/leftovers.h"
#include "sim/base/memory.h"
#include "sim/rig/import/child_process.h"

namespace knuckle {

namespace {

constexpr char DONE = 'd', FAILED = 'f';
/// Drivers of GPUs reserve far more address space than they use [bytes].
constexpr uint64_t MUCH = uint64_t{1} << 44;

/// Tells the parent, as a limit of processor time does, that the time is over.
void endForTime(int)
{
    clearLeftovers();
    std::signal(SIGXCPU, SIG_DFL);
    std::raise(SIGXCPU);
}

std::vector<uint8_t> bytesOf(char kind, const std::string& text)
{
    std::vector<uint8_t> bytes{static_cast<uint8_t>(kind)};
    bytes.insert(bytes.end(), text.begin(), text.end());
    return bytes;
}

}  // namespace

BoundedResult runBounded(const std::function<std::string()>& work, int seconds)
{
    const auto inChild = [&] {
        std::signal(SIGALRM, endForTime);
        alarm(static_cast<unsigned>(seconds));
        try {
            return bytesOf(DONE, work());
        } catch (const std::exception& error) {
            return bytesOf(FAILED, error.what());
        }
    };
    try {
        const auto limit = addressSpaceLimit();
        const uint64_t used = addressSpaceInUse();
        ChildLimits limits;
        limits.extraMemory = !limit ? MUCH : *limit > used ? *limit - used : 0;
        limits.seconds = seconds + 1;  // the child is first to end what it has started
        const ChildResult result = runInChild(inChild, limits);
        if (!result.ok || result.bytes.empty()) return {{}, result.failure};
        const std::string text(result.bytes.begin() + 1, result.bytes.end());
        if (result.bytes[0] == DONE) return {text, {}};
        return {{}, text.empty() ? "failed" : text};
    } catch (const std::exception& error) {
        return {{}, error.what()};
    }
}

}  // namespace knuckle
