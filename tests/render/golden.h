#pragma once

#include <string>

#include "render/picture/image.h"

namespace knuckle::test {

/// Compares `image` with golden/<name>.png by the default limits of `knuckle compare`. On failure the picture and the
/// difference are written to the build folder, and named. KNUCKLE_RENEW_GOLDEN=1 writes the golden image instead.
///
/// For worlds that no scene file can describe; scenes have their goldens in tests/golden.
void expectGolden(const std::string& name, const Image& image);

}  // namespace knuckle::test
