#pragma once

#include "shared/release_types.h"
#include "sim/solver/measure/releases.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// What lets go of bodies when something happens to them (World::releases), and how they then move on. It all happens
/// on the GPU: watching writes into bodyReleases, which mover_release obeys.
class ReleaseStage : public Stage {
public:
    /// Of a world in which anything may be let go.
    static bool isNeeded(const World& world);
    explicit ReleaseStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// At the end of a substep: whether anything has happened that lets go in the next one.
    void watch(Recorder& recorder) const;
    /// At the start of a substep, and when it is integrated: notes what is let go in it, once asked to.
    void noteBefore(Recorder& recorder) const;
    void noteAfter(Recorder& recorder) const;
    void startNotes() { notes_ = true; }
    /// Of all bodies that were let go so far, but for those that never were held. @param substep done so far.
    std::vector<LetGo> letGo(const std::vector<gpu::uvec2>& bodyReleases, uint32_t substep) const;

    Buffer<gpu::Release> releases;      ///< World::releases.
    Buffer<uint32_t> releaseEntries;    ///< Per release: which of bodyReleases it lets go.
    Buffer<uint32_t> releaseLimps;      ///< Per release: what of puppets it makes limp, among all that clips move.
    Buffer<gpu::uvec2> releaseWatches;  ///< Release and body, a thread each: by impulse, by touch, by region.
    Buffer<gpu::vec4> releaseImpulses;  ///< Per watch by impulse and substep of a step: of contacts [N s].
    Buffer<gpu::vec4> releaseNotes;     ///< Per entry of bodyReleases, three: its velocity before it was let go, the
                                        ///< change beyond gravity and contacts, which part of it joints did; w of
                                        ///< that: what contacts gave [m/s].

private:
    const gpu::StepParameters& parameters_;
    bool byImpulse_, byTouch_, byRegion_, notes_ = false;
    Pass impulse_;
    Pass touch_{*this, "release/release_touch", {}, byTouch_};
    Pass region_{*this, "release/release_region", {}, byRegion_};
    Pass before_{*this, "release/release_note", {{"BEFORE", "1"}}};
    Pass after_{*this, "release/release_note"};
};

}  // namespace knuckle
