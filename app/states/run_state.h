#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/states/block_file.h"
#include "render/renderer.h"
#include "sim/solver/solver.h"

namespace knuckle {

/// What the renderers of a run's views carry on, by the names of their cameras; "": of the scene's own shots.
using CameraStates = std::map<std::string, RendererState>;

/// All that a run carries on from a frame to the next.
struct RunState {
    uint64_t frame = 1;  ///< The frame that shows it.
    SolverState solver;
    CameraStates cameras = {};                ///< Empty: nothing was drawn.
    std::optional<BufferState> between = {};  ///< What is drawn before the last step; none: the frame is after it.
};

/// Blocks "state N/...".
std::vector<std::string> packState(const RunState& state);
/// @throws InputError if the file has no such state.
RunState unpackState(const BlockReader& file, uint64_t frame);
/// Blocks "camera N/...": what the renderer carries into a frame.
std::vector<std::string> packCamera(uint64_t frame, const RendererState& camera);
/// @throws InputError if the file has none of that frame.
RendererState unpackCamera(const BlockReader& file, uint64_t frame);
bool hasState(const BlockReader& file, uint64_t frame);
/// Frames of which there is a whole state, in order.
std::vector<uint64_t> statesOf(const BlockReader& file);
/// Frames that can be drawn, in order.
std::vector<uint64_t> framesOf(const BlockReader& file);

}  // namespace knuckle
