#pragma once

#include "app/branch/branch.h"
#include "app/film/frame_drawing.h"
#include "sim/solver/solver.h"

namespace knuckle {

/// Brings a solver to the frame with which a branch begins. @param solver of Branch::world().
/// @param drawing gets what its camera has to see before that frame; null: nothing is drawn.
/// @throws InputError for states of another version, and as Solver::carryOver().
void beginBranch(const Branch& branch, Gpu& gpu, const Scene& scene, Solver& solver, FrameDrawing* drawing);

}  // namespace knuckle
