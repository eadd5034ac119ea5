#pragma once

#include <string>
#include <vector>

#include "app/scene/scene_file.h"
#include "sim/solver/solver.h"

namespace knuckle::test {

/// What happened in a scene at worst, or what may happen in any of its frames. Bounds are twice what was measured.
struct Watched {
    float gap = 0.0f;              ///< Of joints [diameters].
    float penetration = 0.0f;      ///< Of any contact [diameters].
    float meanPenetration = 0.0f;  ///< Of those that overlap [diameters].
    float shapeError = 0.0f;       ///< How far bodies are from rigid [diameters].
    float speed = 0.0f;            ///< [m/s]
    float rise = 0.0f;             ///< Of the energy over the least so far [share of the energy at the start].
    float low = 0.0f;              ///< How far below the floor a particle's centre is [diameters].
    float far = 0.0f;              ///< How far from the middle, along x or z [m].
    float stretch = 0.0f;          ///< Of ropes and cloth, on the mean.
    float strain = 0.0f;           ///< Of soft bodies, on the mean.
    float densityError = 0.0f;     ///< Of fluids, on the mean.
};

/// The GL context of the whole test program: making one takes longer than most tests.
Gpu& gpu();

/// A scene of assets/scenes, changed by some `--set path=value`.
Scene sceneOf(const std::string& name, const std::vector<std::string>& changes);

/// Runs a scene and looks at it in every frame. Fails the test where its state is not finite or a kernel reports a
/// problem. @param floor its height [m]. @returns the worst of all frames.
Watched watch(Solver& solver, const Scene& scene, double seconds, float floor);

/// The root mean square speed of what moves, by mass [m/s].
double meanSpeed(const Scene& scene, Solver& solver);

}  // namespace knuckle::test
