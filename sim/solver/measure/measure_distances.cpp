#include <algorithm>
#include <cmath>

#include "sim/solver/measure/measure.h"

namespace knuckle {

void measureDistances(Measures& out, const World& world, const ParticleState& particles, const std::vector<bool>& torn)
{
    double sum = 0.0;
    uint32_t count = 0;
    size_t distance = 0;
    for (const Strand& row : world.strands)
        for (size_t k = 0; k < row.restLengths.size(); ++k) {
            if (torn[distance++] || row.kind != DistanceKind::Stretch) continue;
            const Vector3f& a = particles.positions[row.particles[k]];
            const Vector3f& b = particles.positions[row.particles[k + 1]];
            const float stretch = std::abs((b - a).norm() / row.restLengths[k] - 1.0f);
            out.worstStretch = std::max(out.worstStretch, stretch);
            sum += static_cast<double>(stretch);
            ++count;
        }
    if (count > 0) out.meanStretch = static_cast<float>(sum / count);
}

}  // namespace knuckle
