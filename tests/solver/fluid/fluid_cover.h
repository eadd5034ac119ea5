#pragma once

#include "tests/solver/fluid/fluid_fixture.h"

namespace knuckle::test {

/// Cover of a particle's kernel: the share, its slope, and the sum of squares of slopes.
struct Cover {
    double share = 0.0, squares = 0.0;
    Vector3d slope = Vector3d::Zero();
    Matrix3d moment = Matrix3d::Zero();  ///< The sum of distances times slopes, negative.
};

/// The share of the kernel behind a plane at z (physics.md).
double behind(double z, double reach);
/// The same behind a wall, which is a little farther for fluids.
double wallShare(const gpu::StepParameters& parameters, double z);
/// What the cell of solid particle j covers for fluid particle i: the product of the shares between its faces along its
/// axes, fading to nothing within the last tenth of a diameter of the lists' reach.
Cover cellCover(const FluidFixture& fixture, uint32_t i, uint32_t j);

}  // namespace knuckle::test
