#include "app/film/film_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "app/export/frame_export.h"
#include "app/film/film_outputs.h"
#include "app/film/film_steps.h"
#include "app/film/run_figures.h"
#include "app/run/counted.h"
#include "app/run/interrupt.h"
#include "app/run/progress.h"
#include "app/run/stopwatch.h"
#include "app/run/tell.h"
#include "app/states/picture_labels.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

/// One run from the first step to the last frame.
class FilmRun {
public:
    FilmRun(const Scene& scene, const FilmOptions& options, const CommonOptions& common, Exporters exporters)
        : scene_(scene), options_(options), begin_(options.branch ? options.branch->frame : 1),
          range_(options.frames.of(scene, begin_)), views_(viewsOf(scene, options)), checkpoint_(openCheckpoint()),
          outputs_(scene, options, range_, std::move(exporters), checkpoint_.get()), gpu_(openGpu(common, work())),
          deviceSeconds_(startClock_.lap()), exporting_(outputs_.exporters, *gpu_),
          solver_(*gpu_, options.branch ? options.branch->world(scene) : scene.world, {}, Loading::AtFirstStep),
          worldSeconds_(startClock_.lap()), steps_(*gpu_, scene, solver_),
          progress_("frame", range_.last, common.quiet), quiet_(common.quiet), done_(begin_ - 1)
    {
        if (outputs_.stats) noteFigures();
        if (!outputs_.sinks.empty()) drawing_ = openDrawing(outputs_.stats.has_value());
        if (!common.quiet) tellLeftOut(outputs_.exporters, scene.world);
        if (outputs_.hasLabels() || checkpoint_ || options.record.any() || options.branch)
            facts_ = factsOf(scene, *gpu_, options.source);
        if (options.record.any()) recording_.emplace(options.record, scene, facts_, begin_, range_.last);
        figures_.device = gpu_->device().name;
        figures_.driverThreads = gpu_->threads();
        figures_.start = {deviceSeconds_, worldSeconds_};
        if (!(checkpoint_ && resume()) && options.branch) beginBranch(*options.branch);
    }

    RunFigures run()
    {
        // Until the first frames exist, shaders are compiled, and there is nothing to finish.
        std::optional<InterruptGuard> interrupt;
        for (uint64_t frame = done_ + 1; frame <= range_.last; ++frame) {
            if (frame > begin_) advance(frame);
            takeFrame(frame);
            if (frame == done_ + WARM_UP) {
                interrupt.emplace();
                figures_.warm = {progress_.seconds(), figures_.simulationSeconds};
            }
            const bool stopped = interrupt && interrupt->isSignalled();
            if (checkpoint_ && (stopped || frame == range_.last || checkpoint_->isDue())) saveCheckpoint(frame);
            if (stopped) {
                if (checkpoint_ && !quiet_)
                    tellUser(fmt::format("knuckle: note: {} has all up to frame {}; --resume goes on from there",
                                         checkpointPath(options_.outputs[0]), frame));
                throw Interrupted{};
            }
            progress_.update(frame);
        }
        if (drawing_) drawing_->wait();
        for (const auto& sink : outputs_.sinks) sink->finish();
        gpu_->checkErrors();
        figures_.frames = range_.last - begin_ + 1;
        figures_.totalSeconds = progress_.seconds();
        if (drawing_) figures_.drawing = drawing_->figures();
        for (const auto& exporter : outputs_.exporters) exporter->finish();
        if (recording_) recording_->finish();
        finishStats();
        return figures_;
    }

    uint64_t stateHash() { return solver_.stateHash(); }

private:
    static constexpr uint64_t WARM_UP = 2;

    std::unique_ptr<Checkpoint> openCheckpoint() const
    {
        if (!options_.checkpoint.seconds) return nullptr;
        return std::make_unique<Checkpoint>(options_.checkpoint, options_.outputs, range_, scene_.world);
    }

    /// Takes the state of an earlier run, if there is one, and gives its frames to exporters and recordings.
    /// @returns whether there was one.
    bool resume()
    {
        const std::optional<RunState> state = checkpoint_->begin(facts_.fingerprint, range_.last);
        if (!quiet_)
            for (const std::string& note : checkpoint_->notes()) tellUser("knuckle: note: " + note);
        if (!state) return false;
        try {
            solver_.loadState(state->solver);
            steps_.goOn(state->frame, state->between);
            if (drawing_) drawing_->loadState(state->cameras);
        } catch (const std::logic_error& error) {
            throw InputError(fmt::format("{}: cannot go on from the other run's state: {}; begin anew without --resume",
                                         checkpointPath(options_.outputs[0]), error.what()));
        }
        done_ = state->frame;
        progress_.begin(done_);
        checkpoint_->replay(begin_, [&](const FrameRecord& record) { give(record); });
        return true;
    }

    void beginBranch(const Branch& branch)
    {
        if (!quiet_) tellBranch(branch);
        knuckle::beginBranch(branch, *gpu_, scene_, solver_, drawing_.get());
        steps_.goOn(begin_, {});
        progress_.begin(done_);
    }

    void tellBranch(const Branch& branch) const
    {
        tellUser("knuckle: note: " + branch.note());
        RunFingerprint there = branch.fingerprint;
        there.world = facts_.fingerprint.world;
        const std::vector<std::string> different = stateDifferences(facts_.fingerprint, there);
        if (!different.empty())
            tellUser(
                fmt::format("knuckle: note: {} is of another program or driver, so bits may differ from that run's: {}",
                            branch.file, fmt::join(different, ", ")));
    }

    void saveCheckpoint(uint64_t frame)
    {
        if (drawing_) drawing_->wait();
        for (const auto& sink : outputs_.sinks) sink->flush();
        checkpoint_->save(saveState(frame));
    }

    /// The average work of a frame.
    FrameWork work() const
    {
        const double drawn = outputs_.sinks.empty() ? 0.0 : static_cast<double>(range_.count());
        return {stepWorkload(scene_.world) * scene_.stepsPerFrame,
                drawingWorkload(views_) * (drawn / static_cast<double>(range_.last - begin_ + 1))};
    }

    std::unique_ptr<FrameDrawing> openDrawing(bool timed)
    {
        if (options_.drawAside.value_or(gpu_->threads().drawAside))
            return std::make_unique<DrawingThread>(*gpu_, scene_, views_, outputs_.sinks, timed);
        return std::make_unique<DrawingHere>(*gpu_, scene_, views_, outputs_.sinks, timed);
    }

    /// With --stats, simulating and drawing are timed separately, so each must end before the other begins. Otherwise
    /// the frame before is drawn or read during this one's steps.
    void advance(uint64_t frame)
    {
        const bool measured = outputs_.stats.has_value();
        if (measured && drawing_) drawing_->wait();
        figures_.start.kernels += secondsOf([&] { solver_.prepare(); });
        {
            const Stopwatch watch(figures_.simulationSeconds);
            steps_.advance(
                frame, [&] { step(frame); },
                [&](const ParticleView& view, const Moment& moment, uint32_t draw) {
                    if (drawing_) drawing_->take(view, {frame, moment.time, isDrawn(frame), draw});
                });
            if (measured) solver_.checkCounters(frame);
        }
        if (drawing_) drawing_->fetch();
        if (!measured) solver_.checkCounters(frame);
        figures_.steps += scene_.clock.at(frame).steps - scene_.clock.at(frame - 1).steps;
    }

    bool isDrawn(uint64_t frame) const { return range_.has(frame) && outputs_.wantsPicture(frame); }

    void noteFigures()
    {
        solver_.timePasses();
        if (std::ranges::none_of(scene_.world.bodies, mayBeLetGo)) return;
        solver_.noteReleases();
        releases_.emplace(scene_.world);
    }

    void step(uint64_t frame)
    {
        solver_.step();
        if (!releases_) return;
        solver_.checkCounters(frame);
        releases_->add(solver_.letGo());
        if (releases_->wantsGaps()) releases_->addGaps(solver_.readParticles(), solver_.readBodies());
    }

    void takeFrame(uint64_t frame)
    {
        const bool wanted = frame >= range_.first;
        const double time = scene_.timeOf(frame);
        if (drawing_) {
            const bool drawn = isDrawn(frame);
            const bool labelled = drawn && outputs_.hasLabels();
            drawing_->take(steps_.view(), {frame, time, drawn, ownDraw(scene_, frame, begin_),
                                           labelled ? labelsOf(facts_, frame, steps_.stateHash()) : PngText()});
        }
        const FrameRecord record = readBack(frame, wanted);
        if (checkpoint_) checkpoint_->log(record);
        give(record);
    }

    void give(const FrameRecord& record)
    {
        if (record.number >= range_.first) exportFrame(record, scene_.world, outputs_.needs, outputs_.exporters);
        else passFrame(record, scene_.world, outputs_.exporters);
        if (recording_) recording_->frame(record);
    }

    /// @param exported whether exporters get the frame.
    FrameRecord readBack(uint64_t frame, bool exported)
    {
        const ExportNeeds needs = exported ? outputs_.needs : ExportNeeds{.views = outputs_.needs.views};
        FrameRecord record{.number = frame};
        if (needs.particles || needs.views || (recording_ && recording_->wantsView(frame)))
            record.view = steps_.readView();
        else if (needs.bodies) record.bodies = solver_.readBodies();
        if (needs.measures) record.measures = solver_.measure();
        if (needs.densities) record.densities = solver_.fluidDensities();
        if (recording_ && recording_->wantsState(frame)) record.state = saveState(frame);
        return record;
    }

    RunState saveState(uint64_t frame)
    {
        RunState state{.frame = frame, .solver = solver_.saveState(), .between = steps_.saveState()};
        if (drawing_) state.cameras = drawing_->saveState();
        return state;
    }

    void finishStats()
    {
        if (!outputs_.stats) return;
        if (releases_) figures_.releases = releases_->figures();
        outputs_.stats->write(statsText(figures_, scene_.world, solver_));
        outputs_.stats->commit();
    }

    const Scene& scene_;
    const FilmOptions& options_;
    uint64_t begin_;  ///< The scene's first frame.
    FrameRange range_;
    std::vector<FilmView> views_;
    std::unique_ptr<Checkpoint> checkpoint_;
    FilmOutputs outputs_;
    LapClock startClock_;
    std::unique_ptr<Gpu> gpu_;
    double deviceSeconds_;
    OpenExporters exporting_;
    Solver solver_;
    double worldSeconds_;
    FilmSteps steps_;
    std::unique_ptr<FrameDrawing> drawing_;
    std::optional<ReleaseLog> releases_;
    RunFacts facts_;
    std::optional<Recording> recording_;
    Progress progress_;
    RunFigures figures_;
    bool quiet_;
    uint64_t done_;  ///< The last frame that an earlier run has done.
};

}  // namespace

RunFigures runFilm(const Scene& scene, const FilmOptions& wanted, const CommonOptions& common, Exporters exporters)
{
    FilmOptions options = wanted;
    const FrameRange range = options.frames.of(scene, options.branch ? options.branch->frame : 1);
    const uint64_t missing = exporters.empty() ? lastMissing(scene, options, range) : range.last;
    if (missing == 0) {
        if (!common.quiet)
            fmt::print("{}, and all are there: {}\n", counted(range.count(), "frame"),
                       fmt::join(options.outputs, ", "));
        return {};
    }
    // A checkpoint is of a run to its end, so that a later one can tell how far it came.
    if (!options.checkpoint.seconds) options.frames.last = missing;
    FilmRun run(scene, options, common, std::move(exporters));
    RunFigures figures = run.run();
    if (!common.quiet)
        fmt::print("{}, {} of them drawn, in {} ({:.1f} frames/s): {}\n", counted(figures.frames, "frame"),
                   figures.drawing.frames, durationText(figures.totalSeconds),
                   static_cast<double>(figures.frames) / std::max(1e-9, figures.totalSeconds),
                   fmt::join(options.outputs, ", "));
    if (options.hash) fmt::print("state hash {}\n", hashText(run.stateHash()));
    return figures;
}

}  // namespace knuckle
