#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace knuckle {

/// Address space that this process uses [bytes].
uint64_t addressSpaceInUse();
/// Limit of its address space (ulimit -v) [bytes]; none: unlimited.
std::optional<uint64_t> addressSpaceLimit();

/// Whether large blocks are refused, so that a failure now is due to lack of memory. Safe in signal handlers.
bool isMemoryShort();
/// The message for the user then, one line.
std::string memoryMessage();

/// Under a limit, makes all threads share one heap; each would reserve 128 MiB of address space for its own. Must be
/// called before the first thread starts.
void saveAddressSpace();

}  // namespace knuckle
