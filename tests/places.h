#pragma once

#include <string>

namespace knuckle::test {

/// Path of a file of the source tree, given from its root. The tree's own path stands in one source only, so that a
/// compiler cache serves every checkout.
std::string inSource(const std::string& file);
/// Path of the program that was built beside the tests.
const std::string& programPath();

}  // namespace knuckle::test
