#pragma once

#include <string>
#include <vector>

#include "app/scene/scene_file.h"
#include "sim/solver/solver.h"

namespace knuckle::test {

/// The worst values in a scene, or bounds for all its frames. Bounds are twice the measured values.
struct Watched {
    float gap = 0.0f;              ///< Of joints [diameters].
    float penetration = 0.0f;      ///< Of any contact [diameters].
    float meanPenetration = 0.0f;  ///< Of overlapping contacts [diameters].
    float shapeError = 0.0f;       ///< Deviation of bodies from rigid ones [diameters].
    float speed = 0.0f;            ///< [m/s]
    float rise = 0.0f;             ///< Of the energy over the least so far, over that at the start.
    float low = 0.0f;              ///< Depth of a particle's centre below the floor [diameters].
    float far = 0.0f;              ///< Distance from the middle, along x or z [m].
    float stretch = 0.0f;          ///< Of ropes and cloth, on average.
    float strain = 0.0f;           ///< Of soft bodies, on average.
    float densityError = 0.0f;     ///< Of fluids, on average.
};

/// The GL context of the whole test program: making one takes longer than most tests.
Gpu& gpu();

/// A scene of assets/scenes, changed by some `--set path=value`.
Scene sceneOf(const std::string& name, const std::vector<std::string>& changes);

/// Runs a scene and measures every frame. Fails the test if its state is not finite or a kernel reports a problem.
/// @param floor its height [m]. @returns the worst of all frames.
Watched watch(Solver& solver, const Scene& scene, double seconds, float floor);

/// The root mean square speed of moving things, weighted by mass [m/s].
double meanSpeed(const Scene& scene, Solver& solver);

}  // namespace knuckle::test
