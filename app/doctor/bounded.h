#pragma once

#include <functional>
#include <string>

namespace knuckle {

/// What a look at something that may crash or hang has brought.
struct BoundedResult {
    std::string text;     ///< What the work returned.
    std::string failure;  ///< Why there is none: "crashed (...)", "took more than 30 s", an exception's message.
};

/// Runs the work in a child process, and ends it and the programs that it has started after that time. Never throws.
BoundedResult runBounded(const std::function<std::string()>& work, int seconds);

}  // namespace knuckle
