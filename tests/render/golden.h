#pragma once

#include <string>

#include "render/picture/image.h"

namespace knuckle::test {

/// Compares `image` with golden/<name>.png. Another driver rounds differently and may decide single edge pixels
/// differently, so two pictures are the same if the mean difference is at most 1 of 255 (rounding gives 0.1) and at
/// most 1 % of the pixels differ by more than 24 of 255 (a missing shadow or sphere is many times that). On failure the
/// picture and the brightened difference are written to the build folder, and named. KNUCKLE_RENEW_GOLDEN=1 writes the
/// golden image instead.
void expectGolden(const std::string& name, const Image& image);

}  // namespace knuckle::test
