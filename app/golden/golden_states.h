#pragma once

#include <string>
#include <vector>

#include "app/states/states_file.h"

namespace knuckle {

/// From what a reference picture is drawn.
struct StoredFrame {
    uint64_t number = 1;
    ViewState view;
    RendererState camera;  ///< What the renderer carries into the frame.
};

/// A state in fewer bytes: places of loose particles are rounded to 1/256 of a diameter or less, and velocities are
/// kept only where colours show them. Bodies keep their bits.
void compact(ViewState& view, const Scene& scene);

/// Writes a file of states, which docs/states.md describes, with blocks "camera N/...".
/// @throws as OutputFile.
void writeStoredFrames(const std::string& path, const Scene& scene, const RunFacts& facts,
                       const std::vector<StoredFrame>& frames);

/// Reads them. States are of the world that was stored, whatever the scene has become since.
class StoredFrames {
public:
    /// @throws InputError as StatesFile.
    explicit StoredFrames(const std::string& path);
    /// @throws InputError if the file has no such frame.
    StoredFrame read(uint64_t frame) const;

private:
    StatesFile file_;
    ViewCoding coding_;
};

}  // namespace knuckle
