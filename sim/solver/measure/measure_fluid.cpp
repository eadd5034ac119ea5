#include <algorithm>

#include "sim/solver/measure/measure.h"

namespace knuckle {

void measureFluids(Measures& out, const std::vector<std::pair<uint32_t, float>>& densities)
{
    if (densities.empty()) return;
    double errors = 0.0, volume = 0.0;
    for (const auto& [particle, density] : densities) {
        const float error = std::max(density - 1.0f, 0.0f);
        errors += error;
        volume += 1.0 / (1.0 + error);
        out.worstDensityError = std::max(out.worstDensityError, error);
    }
    const auto count = static_cast<double>(densities.size());
    out.meanDensityError = static_cast<float>(errors / count);
    out.fluidVolumeError = static_cast<float>(1.0 - volume / count);
}

}  // namespace knuckle
