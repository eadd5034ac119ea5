#pragma once

#include <string>

namespace knuckle::test {

/// Path of a file of the source tree, relative to its root. Only one source contains the tree's own path, so that a
/// compiler cache serves every checkout.
std::string inSource(const std::string& file);
/// Path of the program built beside the tests.
const std::string& programPath();

}  // namespace knuckle::test
