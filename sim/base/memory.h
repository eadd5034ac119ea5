#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace knuckle {

/// [bytes] of address space that this process has taken.
uint64_t addressSpaceInUse();
/// [bytes] that it may have (ulimit -v); none: as much as it likes.
std::optional<uint64_t> addressSpaceLimit();

/// Whether large blocks are refused, so that what fails now does so for want of memory. Fit for signal handlers.
bool isMemoryShort();
/// What the user reads then, one line.
std::string memoryMessage();

/// Under a limit: has all threads share one heap. Each would reserve 128 MiB of address space for its own. To be called
/// before the first thread.
void saveAddressSpace();

}  // namespace knuckle
