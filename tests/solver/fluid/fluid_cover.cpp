#include "tests/solver/fluid/fluid_cover.h"

#include <algorithm>
#include <cmath>

#include "shared/fluid_constants.h"

namespace knuckle::test {

double behind(double z, double reach)
{
    const double t = std::clamp(1.0 - z / reach, 0.0, 1.0);
    return 3.5 * std::pow(t, 6) - 4.5 * std::pow(t, 7) + 1.5 * std::pow(t, 8);
}

double wallShare(const gpu::StepParameters& parameters, double z)
{
    return behind(z + FLUID_WALL_GAP * parameters.fluidSpacing, parameters.fluidReach);
}

Cover cellCover(const FluidFixture& fixture, uint32_t i, uint32_t j)
{
    const gpu::StepParameters& p = fixture.parameters();
    const double d = p.diameter, all = 2.0 * wallShare(p, 0.0);
    const Vector3d offset = fixture.place(i) - fixture.place(j);
    const Eigen::Quaterniond turn = fixture.turns[j].cast<double>();
    const Vector3d r = turn.conjugate() * offset;
    const double u = std::clamp((p.fluidListReach - offset.norm()) / (0.1 * d), 0.0, 1.0);
    const double scale = FLUID_SOLID_COVER * u * u * (3.0 - 2.0 * u);
    // The part of the kernel below t along one axis.
    const auto below = [&](double t) { return (t < 0.0 ? wallShare(p, -t) : all - wallShare(p, t)) / all; };
    Vector3d share, slope, moment;
    for (int k = 0; k < 3; ++k) {
        const double low = r[k] - 0.5 * d, high = r[k] + 0.5 * d;
        const double atLow = FluidFixture::derivative(below, low), atHigh = FluidFixture::derivative(below, high);
        share[k] = below(high) - below(low);
        slope[k] = atHigh - atLow;
        moment[k] = low * atLow - high * atHigh;
    }
    const Vector3d sides = scale * Vector3d(share.y() * share.z(), share.x() * share.z(), share.x() * share.y());
    Cover cover{scale * share.prod()};
    cover.slope = turn * sides.cwiseProduct(slope);
    const Matrix3d axes = turn.toRotationMatrix(), moments = sides.cwiseProduct(moment).asDiagonal();
    cover.moment = axes * moments * axes.transpose();
    return cover;
}

}  // namespace knuckle::test
