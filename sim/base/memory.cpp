#include "sim/base/memory.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace knuckle {

namespace {

constexpr size_t LARGE_BLOCK = size_t{128} << 20;

}  // namespace

uint64_t addressSpaceInUse()
{
    uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

std::optional<uint64_t> addressSpaceLimit()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
    return limit.rlim_cur;
}

bool isMemoryShort()
{
    void* block = mmap(nullptr, LARGE_BLOCK, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (block == MAP_FAILED) return true;
    munmap(block, LARGE_BLOCK);
    return false;
}

std::string memoryMessage()
{
    const auto limit = addressSpaceLimit();
    return "out of memory; take fewer particles or smaller frames" +
           (limit ? fmt::format(", or raise the limit of {} MiB (ulimit -v)", *limit >> 20) : "");
}

void saveAddressSpace()
{
    if (addressSpaceLimit()) mallopt(M_ARENA_MAX, 1);
}

}  // namespace knuckle
