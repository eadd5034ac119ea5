#include "app/serve/live_loop.h"

#include <algorithm>
#include <utility>

#include "app/json/json.h"
#include "app/run/stopwatch.h"
#include "app/scene/names/named.h"
#include "app/serve/ball.h"
#include "app/serve/live_words.h"
#include "sim/base/errors.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr double FRAME_SECONDS = 1.0 / 30.0, FIGURES_SECONDS = 0.1, MEASURE_SECONDS = 1.0;
constexpr std::chrono::microseconds LONGEST_WAIT{50000};  // between looks for signals

template <typename Moment>
Moment later(Moment moment, double seconds)
{
    return moment + std::chrono::duration_cast<typename Moment::duration>(Seconds(seconds));
}

template <typename Moment>
double since(Moment moment)
{
    return Seconds(Moment::clock::now() - moment).count();
}

}  // namespace

LiveLoop::LiveLoop(Gpu& gpu, const LoadServed& load, std::unique_ptr<ServedScene> served, LiveFeed& feed,
                   const ServeOptions& options)
    : gpu_(gpu), load_(load), feed_(feed), share_(options.share),
      shown_(std::make_unique<ShownScene>(gpu, std::move(served), feed)),
      pace_(static_cast<double>(live().world().settings.timeStep))
{
    if (!options.log.empty()) log_.emplace(options.log, shown_->served->scene.name, fingerprint(live().world()));
}

void LiveLoop::turn()
{
    for (const Input& input : feed_.inbox.take()) take(input);
    advance(pace_.due());
    drawIfDue();
    if (feed_.listeners > 0 && Clock::now() >= nextFigures_) tellFigures();
    feed_.inbox.wait(std::min(LONGEST_WAIT, pace_.untilNext()));
}

void LiveLoop::finish()
{
    gpu_.checkErrors();
    if (log_) log_->finish(live().steps(), stateHash());
}

void LiveLoop::take(const Input& input)
{
    nextFigures_ = {};
    try {
        const std::string answer = obey(input);
        if (input.answer) input.answer->set_value(answer);
    } catch (const InputError& error) {
        message_ = error.what();
        if (input.answer) input.answer->set_exception(std::current_exception());
    }
}

std::string LiveLoop::obey(const Input& input)
{
    ++version_;
    switch (input.kind) {
        case InputKind::Orbit:
        case InputKind::Pan:
        case InputKind::Zoom:
        case InputKind::Home: steer(input); break;
        case InputKind::Pause: pace_.pause(true); break;
        case InputKind::Run: pace_.pause(false); break;
        case InputKind::Step: pace_.ask(input.count); break;
        case InputKind::Speed: pace_.setSpeed(static_cast<double>(input.factor)); break;
        case InputKind::Share: share_.setLeast(static_cast<double>(input.factor)); break;
        case InputKind::Reset: reset(); break;
        case InputKind::Pick:
        case InputKind::Grab:
        case InputKind::Throw: return touch(input);
        case InputKind::Ball: throwBall(input.at, input.factor); break;
        case InputKind::Drag: drag(input.at); break;
        case InputKind::Drop: hand().drop(); break;
        case InputKind::Push: push(input); break;
        case InputKind::Release: change({.kind = ChangeKind::Release, .name = input.name}); break;
        case InputKind::Set: change({.kind = ChangeKind::Set, .name = input.name, .value = input.value}); break;
        case InputKind::Restart: restart(input.sets); break;
    }
    return "{}";
}

void LiveLoop::steer(const Input& input)
{
    steered_ = Clock::now();
    camera_ = input.kind == InputKind::Home ? shown_->drawing.home() : seenFrom();
    if (input.kind == InputKind::Orbit) camera_->orbit(input.by);
    if (input.kind == InputKind::Pan) camera_->pan(input.by);
    if (input.kind == InputKind::Zoom) camera_->zoom(input.factor);
}

/// As in the last picture; where nobody looks, as it would be.
FreeCamera LiveLoop::seenFrom()
{
    if (camera_) return *camera_;
    if (feed_.viewers == 0) shown_->drawing.look(live().solver().view(), live().time());
    return shown_->drawing.camera();
}

Picked LiveLoop::pick(const Eigen::Vector2f& at)
{
    return hand().pick(live().solver().view(), live().time(), seenFrom(), at);
}

std::string LiveLoop::touch(const Input& input)
{
    const Picked picked = pick(input.at);
    if (input.kind == InputKind::Grab) grab(picked);
    if (input.kind == InputKind::Throw) throwAway(picked, input.factor);
    return wordsOf(picked).dump();
}

void LiveLoop::grab(const Picked& picked)
{
    if (picked.canBePulled()) hand().grab(picked, live().solver());
    dragged_ = Clock::now();
}

void LiveLoop::drag(const Eigen::Vector2f& at)
{
    if (!hand().holds()) return;
    hand().moveTo(seenFrom().placeAt(at, hand().depth()));
    steered_ = dragged_ = Clock::now();
}

/// Gives what is under the mouse a speed away from the camera.
void LiveLoop::throwAway(const Picked& picked, float speed)
{
    if (picked.body == NO_INDEX) return;
    const Eigen::Vector3f away = (picked.place - seenFrom().position()).normalized();
    const auto size = speed * static_cast<float>(hand().massOf(picked.body));
    change({.name = picked.name, .impulse = size * away, .at = live().solver().readBodies().at(picked.body).position});
}

bool LiveLoop::hasBall()
{
    return std::ranges::find(live().world().objects, BALL, &Object::name) != live().world().objects.end();
}

/// From where the camera stands, to what is under the mouse.
void LiveLoop::throwBall(const Eigen::Vector2f& at, float speed)
{
    if (!hasBall()) throw InputError("there is no ball; serve the scene with one, as --ball 0.15");
    const FreeCamera camera = seenFrom();
    const float depth = 0.1f * (camera.target() - camera.position()).norm();
    const Eigen::Vector3f along = camera.placeAt(at, depth) - camera.position();
    change({.kind = ChangeKind::Throw,
            .name = BALL,
            .at = camera.position() + along,
            .velocity = speed * along.normalized()});
}

void LiveLoop::push(const Input& input)
{
    const std::vector<uint32_t> bodies = bodiesNamed(live().world(), input.name);
    const Eigen::Vector3f at = input.place ? *input.place : live().solver().readBodies().at(bodies.at(0)).position;
    change({.name = input.name, .impulse = input.impulse, .at = at});
}

/// What is logged is what is applied, and only if it was.
void LiveLoop::change(const Change& made)
{
    const uint64_t step = live().steps();
    live().apply(made);
    if (log_) log_->add(step, made);
    ++version_;
}

void LiveLoop::reset()
{
    change({.kind = ChangeKind::Reset});
    hand().drop();
    pace_.clear();
}

void LiveLoop::restart(const std::vector<std::string>& sets)
{
    std::vector<std::string> all = sets_;
    all.insert(all.end(), sets.begin(), sets.end());
    std::unique_ptr<ShownScene> next;
    try {
        next = std::make_unique<ShownScene>(gpu_, load_(all), feed_);
    } catch (const DeviceError& error) {
        // The scene that runs goes on.
        throw InputError(error.what());
    }
    if (log_) log_->restart(live().steps(), all, fingerprint(next->live.world()));
    shown_ = std::move(next);
    sets_ = std::move(all);
    pace_.begin(static_cast<double>(live().world().settings.timeStep));
    measured_.reset();
}

void LiveLoop::advance(uint32_t steps)
{
    if (steps == 0) return;
    pace_.took(steps, secondsOf([&] {
                   for (uint32_t k = 0; k < steps; ++k) step();
                   live().check();
               }));
    share_.note(pace_.isBehind());
    ++version_;
}

void LiveLoop::step()
{
    constexpr double LONGEST_HOLD = 5.0;  // a viewer that has gone lets go [s]
    if (hand().holds() && since(dragged_) > LONGEST_HOLD) hand().drop();
    if (hand().holds()) pull();
    live().step();
}

void LiveLoop::pull()
{
    live().check();
    try {
        if (const std::optional<Change> made = hand().pull(live().solver())) change(*made);
    } catch (const InputError& error) {
        message_ = error.what();
        hand().drop();
    }
}

/// More while somebody moves the picture and waits for it, and all if nothing else is to be done.
double LiveLoop::allowedShare() const
{
    constexpr double WHILE_STEERED = 0.5;
    if (pace_.isPaused()) return 1.0;
    return since(steered_) < 1.0 ? std::max(share_.now(), WHILE_STEERED) : share_.now();
}

void LiveLoop::drawIfDue()
{
    LiveDrawing& drawing = shown_->drawing;
    if (feed_.viewers == 0 || drawn_ == version_ || !drawing.isIdle()) return;
    if (since(drawStarted_) < std::max(FRAME_SECONDS, drawing.seconds() / allowedShare())) return;
    drawn_ = version_;
    drawStarted_ = Clock::now();
    pictures_.note();
    drawing.draw(live().solver().view(), live().time(), camera_);
}

/// What takes a read of the whole state, once a second, or as often as it costs a hundredth of the time.
void LiveLoop::measure()
{
    if (Clock::now() < nextMeasure_ || measured_ == live().steps()) return;
    const double seconds = secondsOf([&] { measures_ = live().solver().measure(); });
    measured_ = live().steps();
    nextMeasure_ = later(Clock::now(), std::max(MEASURE_SECONDS, 100.0 * seconds));
}

void LiveLoop::tellFigures()
{
    measure();
    Json figures{{"step", live().steps()},
                 {"time", live().time()},
                 {"stepMilliseconds", 1e3 * pace_.stepSeconds()},
                 {"drawMilliseconds", 1e3 * shown_->drawing.seconds()},
                 {"picturesPerSecond", pictures_.now()},
                 {"paused", pace_.isPaused()},
                 {"speed", pace_.speed()},
                 {"share", share_.least()},
                 {"maxSpeed", measures_.maxSpeed},
                 {"energy", measures_.kineticEnergy},
                 {"contacts", measures_.contactCount},
                 {"hasBall", hasBall()},
                 {"particles", live().world().particles.size()},
                 {"viewers", feed_.viewers.load()},
                 {"fields", wordsOf(live().fields())},
                 {"restarts", sets_},
                 {"message", std::exchange(message_, "")}};
    feed_.figures.put(figures.dump());
    nextFigures_ = later(Clock::now(), FIGURES_SECONDS);
}

}  // namespace knuckle
