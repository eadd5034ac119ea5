#pragma once

#include "shared/release_types.h"
#include "sim/solver/measure/releases.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Lets go of bodies when something happens to them (World::releases), and notes how they then move. It all happens on
/// the GPU: watching writes into bodyReleases, which mover_release obeys.
class ReleaseStage : public Stage {
public:
    /// Whether anything in a world may be let go.
    static bool isNeeded(const World& world);
    explicit ReleaseStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// At the end of a substep: checks whether anything has happened that lets go in the next one.
    void watch(Recorder& recorder) const;
    /// At the start of a substep, and when it is integrated: notes what is let go in it, once asked to.
    void noteBefore(Recorder& recorder) const;
    void noteAfter(Recorder& recorder) const;
    void startNotes() { notes_ = true; }
    /// All bodies that were let go so far, except those that were never held. @param substep done so far.
    std::vector<LetGo> letGo(const std::vector<gpu::uvec2>& bodyReleases, uint32_t substep) const;

    Buffer<gpu::Release> releases;      ///< World::releases.
    Buffer<uint32_t> releaseEntries;    ///< Per release: entries of bodyReleases that it lets go.
    Buffer<uint32_t> releaseLimps;      ///< Per release: animated bodies of puppets that it makes limp.
    Buffer<gpu::uvec2> releaseWatches;  ///< Release and body, one thread each: by impulse, by touch, by region.
    Buffer<gpu::vec4> releaseImpulses;  ///< Per watch by impulse and substep of a step: impulse of contacts [N s].
    Buffer<gpu::vec4> releaseNotes;     ///< Per entry of bodyReleases, three: the velocity before it was let go; the
                                        ///< change beyond gravity and contacts; the part of that which joints gave; w
                                        ///< of the last: what contacts gave [m/s].

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
