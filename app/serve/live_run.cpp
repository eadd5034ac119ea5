#include "app/serve/live_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <utility>
#include "app/film/branch_run.h"
#include "app/json/json.h"
#include "app/run/interrupt.h"
#include "app/run/stopwatch.h"
#include "app/run/tell.h"
#include "app/scene/names/named.h"
#include "app/serve/change_log.h"
#include "app/serve/hand.h"
#include "app/serve/live_view.h"
#include "app/serve/pace.h"
#include "app/serve/web/page.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"
#include "sim/solver/workload.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double FRAME_SECONDS = 1.0 / 30.0, FIGURES_SECONDS = 0.1, MEASURE_SECONDS = 1.0;
constexpr std::chrono::microseconds LONGEST_WAIT{50000};  // between looks for signals

/// The state of a scene that viewers steer.
class LiveRun {
public:
    LiveRun(const Scene& scene, const Branch* branch, LiveFeed& feed, const std::string& log,
            const CommonOptions& common)
        : scene_(scene), feed_(feed),
          gpu_(openGpu(common, FrameWork{stepWorkload(scene.world), drawingWorkload(liveSettings(scene))})),
          solver_(*gpu_, branch != nullptr ? branch->world(scene) : scene.world),
          pace_(static_cast<double>(scene.world.settings.timeStep))
    {
        if (branch != nullptr) beginBranch(*branch, *gpu_, scene, solver_, nullptr);
        begin_ = solver_.saveState();
        view_.emplace(*gpu_, scene, solver_.view());
        hand_.emplace(*gpu_, scene.world, liveSettings(scene));
        if (!log.empty()) log_.emplace(log, scene.name, fingerprint(scene.world));
    }

    /// One turn: inputs, steps, a frame, figures, a rest.
    void turn()
    {
        for (const Input& input : feed_.inbox.take()) take(input);
        advance(pace_.due());
        const Clock::time_point now = Clock::now();
        if (feed_.viewers > 0 && drawn_ != version_ && now >= nextFrame_) draw();
        if (feed_.listeners > 0 && now >= nextFigures_) tellFigures();
        std::chrono::microseconds rest = std::min(LONGEST_WAIT, pace_.untilNext());
        if (feed_.viewers > 0 && drawn_ != version_) rest = std::min(rest, until(nextFrame_));
        feed_.inbox.wait(rest);
    }

    uint64_t stateHash() { return solver_.stateHash(); }
    /// @throws RunError for a disk that is full, or a mistake that the driver tells.
    void finish()
    {
        gpu_->checkErrors();
        if (log_) log_->finish(steps_, solver_.stateHash());
    }

private:
    static std::chrono::microseconds until(Clock::time_point moment)
    {
        return std::max(std::chrono::microseconds(0),
                        std::chrono::duration_cast<std::chrono::microseconds>(moment - Clock::now()));
    }
    static Clock::time_point in(double seconds)
    {
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
    }

    double time() const { return static_cast<double>(steps_) * static_cast<double>(scene_.world.settings.timeStep); }

    void take(const Input& input)
    {
        try {
            const std::string answer = obey(input);
            if (input.answer) input.answer->set_value(answer);
        } catch (const InputError& error) {
            message_ = error.what();
            if (input.answer) input.answer->set_value(Json{{"message", message_}}.dump());
        }
        nextFigures_ = {};
    }

    /// @returns what is answered.
    std::string obey(const Input& input)
    {
        ++version_;
        switch (input.kind) {
            case InputKind::Orbit: steered().orbit(input.by); break;
            case InputKind::Pan: steered().pan(input.by); break;
            case InputKind::Zoom: steered().zoom(input.factor); break;
            case InputKind::Home: view_->goHome(); break;
            case InputKind::Pause: pace_.pause(true); break;
            case InputKind::Run: pace_.pause(false); break;
            case InputKind::Step: pace_.ask(input.count); break;
            case InputKind::Speed: pace_.setSpeed(static_cast<double>(input.factor)); break;
            case InputKind::Reset: reset(); break;
            case InputKind::Pick: return jsonOf(pick(input.at));
            case InputKind::Grab: return grab(input.at);
            case InputKind::Drag: drag(input.at); break;
            case InputKind::Drop: hand_->drop(); break;
            case InputKind::Throw: return throwBody(input);
            case InputKind::Push: push(input); break;
            case InputKind::Release: change({.kind = ChangeKind::Release, .name = input.name}); break;
        }
        return "{}";
    }

    FreeCamera& steered() { return view_->steered(solver_.view(), time()); }
    const FreeCamera& seenFrom() { return view_->seenFrom(solver_.view(), time()); }
    Picked pick(const Eigen::Vector2f& at) { return hand_->pick(solver_.view(), time(), seenFrom(), at); }

    static std::string jsonOf(const Picked& picked)
    {
        const Eigen::Vector3f& place = picked.place;
        return Json{{"name", picked.name},
                    {"isBody", picked.body != NO_INDEX},
                    {"place", {place.x(), place.y(), place.z()}},
                    {"depth", picked.depth}}
            .dump();
    }

    std::string grab(const Eigen::Vector2f& at)
    {
        const Picked picked = pick(at);
        if (picked.body != NO_INDEX) hand_->grab(picked, solver_.readBodies().at(picked.body));
        dragged_ = Clock::now();
        return jsonOf(picked);
    }

    void drag(const Eigen::Vector2f& at)
    {
        if (!hand_->holds()) return;
        hand_->moveTo(seenFrom().placeAt(at, hand_->depth()));
        dragged_ = Clock::now();
    }

    /// Gives what is under the mouse a speed away from the camera.
    std::string throwBody(const Input& input)
    {
        const Picked picked = pick(input.at);
        if (picked.body == NO_INDEX) return jsonOf(picked);
        const Eigen::Vector3f away = (picked.place - seenFrom().position()).normalized();
        const auto size = input.factor * static_cast<float>(hand_->massOf(picked.body));
        change({.name = picked.name, .impulse = size * away, .at = solver_.readBodies().at(picked.body).position});
        return jsonOf(picked);
    }

    void push(const Input& input)
    {
        const std::vector<uint32_t> bodies = bodiesNamed(scene_.world, input.name);
        const Eigen::Vector3f at = input.place ? *input.place : solver_.readBodies().at(bodies.at(0)).position;
        change({.name = input.name, .impulse = input.impulse, .at = at});
    }

    /// What is logged is what is applied, and only if it was.
    void change(const Change& made)
    {
        applyChange(solver_, scene_.world, made);
        if (log_) log_->add(steps_, made);
        ++version_;
    }

    void reset()
    {
        solver_.loadState(begin_);
        if (log_) log_->add(steps_, {.kind = ChangeKind::Reset});
        steps_ = 0;
        hand_->drop();
        pace_.clear();
    }

    void advance(uint32_t steps)
    {
        if (steps == 0) return;
        pace_.took(steps, secondsOf([&] {
                       for (uint32_t k = 0; k < steps; ++k) step();
                       solver_.checkCounters(steps_);
                   }));
        ++version_;
    }

    void step()
    {
        constexpr double LONGEST_HOLD = 5.0;  // a viewer that has gone lets go [s]
        if (hand_->holds() && Seconds(Clock::now() - dragged_).count() > LONGEST_HOLD) hand_->drop();
        if (hand_->holds()) pull();
        solver_.step();
        ++steps_;
    }

    void pull()
    {
        solver_.checkCounters(steps_);
        try {
            change(hand_->pull(solver_.readBodies().at(hand_->body())));
        } catch (const InputError& error) {
            message_ = error.what();
            hand_->drop();
        }
    }

    /// The simulation gets half of the time at least, up to a limit at which pictures would become too rare.
    void draw()
    {
        constexpr double LONGEST_GAP = 0.1;
        const double seconds = secondsOf([&] { feed_.frame.put(view_->draw(solver_.view(), time())); });
        drawn_ = version_;
        const double gap = pace_.isPaused() ? 0.0 : std::min(seconds, LONGEST_GAP);
        nextFrame_ = in(std::max(gap, FRAME_SECONDS - seconds));
        drawSeconds_ = seconds;
    }

    /// What takes a read of the whole state, once a second, or as often as it costs a tenth of the time.
    void measure()
    {
        if (Clock::now() < nextMeasure_ || measured_ == steps_ + 1) return;
        const double seconds = secondsOf([&] { measures_ = solver_.measure(); });
        measured_ = steps_ + 1;
        nextMeasure_ = in(std::max(MEASURE_SECONDS, 10.0 * seconds));
    }

    void tellFigures()
    {
        measure();
        const Json figures{{"step", steps_},
                           {"time", time()},
                           {"stepMilliseconds", 1e3 * pace_.stepSeconds()},
                           {"drawMilliseconds", 1e3 * drawSeconds_},
                           {"paused", pace_.isPaused()},
                           {"speed", pace_.speed()},
                           {"maxSpeed", measures_.maxSpeed},
                           {"energy", measures_.kineticEnergy},
                           {"contacts", measures_.contactCount},
                           {"particles", scene_.world.particles.size()},
                           {"viewers", feed_.viewers.load()},
                           {"message", std::exchange(message_, "")}};
        feed_.figures.put(figures.dump());
        nextFigures_ = in(FIGURES_SECONDS);
    }

    const Scene& scene_;
    LiveFeed& feed_;
    std::unique_ptr<Gpu> gpu_;
    Solver solver_;
    SolverState begin_;
    std::optional<LiveView> view_;
    std::optional<Hand> hand_;
    std::optional<ChangeLog> log_;
    Pace pace_;
    uint64_t steps_ = 0;                ///< Since the start.
    uint64_t version_ = 1, drawn_ = 0;  ///< Of what a picture shows; of the last picture.
    uint64_t measured_ = 0;             ///< Steps at the last measure, and 1.
    double drawSeconds_ = 0.0;
    Measures measures_;
    std::string message_;  ///< What was refused of late.
    Clock::time_point dragged_, nextFrame_, nextFigures_, nextMeasure_;
};

}  // namespace

void serveScene(const Scene& scene, const Branch* branch, const ServeOptions& options, const CommonOptions& common)
{
    LiveFeed feed;
    // Before all that takes long: who mistypes a port learns it at once.
    const WebServer server(options.web, livePage(scene.name), feed);
    LiveRun run(scene, branch, feed, options.log, common);
    const InterruptGuard guard;
    if (!common.quiet) {
        const bool bare = options.web.host.find(':') == std::string::npos;
        fmt::print("{} is shown at http://{}:{}/{}; Ctrl-C ends it\n", scene.name,
                   bare ? options.web.host : "[" + options.web.host + "]", server.port(),
                   options.web.token.empty() ? "" : "?token=TEXT");
        flushStandardOutput();
    }
    while (!guard.isSignalled()) run.turn();
    run.finish();
    if (options.hash) fmt::print("state hash {}\n", hashText(run.stateHash()));
    throw Interrupted{};
}

}  // namespace knuckle
