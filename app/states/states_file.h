#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/overrides.h"
#include "app/scene/scene_file.h"
#include "app/states/block_file.h"
#include "app/states/run_fingerprint.h"
#include "app/states/run_state.h"
#include "app/states/view_coding.h"

namespace knuckle {

/// Where the scene of a run came from.
struct SceneSource {
    std::string file;               ///< As the user named it.
    std::vector<Override> changes;  ///< What --set and the like changed.
};

/// What a file of states says of its run.
struct RunFacts {
    RunFingerprint fingerprint;
    SceneSource source;
    std::string sceneName = {};
    double framesPerSecond = 60.0;
    uint32_t stepsPerFrame = 1;
    uint64_t particles = 0, bodies = 0;
    double diameter = 0.0;      ///< Of particles [m].
    std::string document = {};  ///< Scene::document; empty: an earlier version has written it.
};

/// Of a run of this scene.
RunFacts factsOf(const Scene& scene, const Gpu& gpu, SceneSource source);

/// Whether a scene has the camera of the run, so that one that moves may go on as it did there.
bool haveSameCamera(const Scene& scene, const RunFacts& facts);

/// Writes the states of a run: what is drawn of each frame, and whole states from which a run can go on.
class StatesWriter {
public:
    /// @throws as OutputFile.
    StatesWriter(const std::string& path, const Scene& scene, const RunFacts& facts);
    void addFrame(uint64_t frame, const ViewState& view);
    void addState(const RunState& state);
    void addCamera(uint64_t frame, const RendererState& camera);
    void commit() { file_.commit(); }

private:
    void add(const std::vector<std::string>& blocks);

    ViewCoding coding_;
    BlockWriter file_;
};

/// Reads what StatesWriter wrote.
class StatesFile {
public:
    /// @throws InputError as BlockReader, and for a file of blocks that are no states.
    explicit StatesFile(const std::string& path);

    const std::string& path() const { return file_.path(); }
    const RunFacts& facts() const { return facts_; }
    const BlockReader& blocks() const { return file_; }
    const std::vector<uint64_t>& frames() const { return frames_; }
    const std::vector<uint64_t>& states() const { return states_; }

private:
    BlockReader file_;
    RunFacts facts_;
    std::vector<uint64_t> frames_, states_;
};

}  // namespace knuckle
