#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/serve/live_run.h"
#include "app/serve/pace.h"
#include "app/serve/picture_share.h"
#include "app/serve/rate.h"
#include "app/serve/shown_scene.h"

namespace knuckle {

/// What the thread that simulates does, over and over: wishes of viewers, steps, a picture, figures, a rest.
class LiveLoop {
public:
    LiveLoop(Gpu& gpu, const LoadServed& load, std::unique_ptr<ServedScene> served, LiveFeed& feed,
             const ServeOptions& options);

    /// One turn.
    void turn();
    uint64_t stateHash() { return live().solver().stateHash(); }
    /// Ends the log. @throws RunError for a disk that is full; DeviceError for a mistake that the driver tells.
    void finish();

private:
    using Clock = std::chrono::steady_clock;

    LiveWorld& live() { return shown_->live; }
    Hand& hand() { return shown_->hand; }
    void take(const Input& input);
    /// @returns what is answered.
    std::string obey(const Input& input);
    void steer(const Input& input);
    std::string touch(const Input& input);
    FreeCamera seenFrom();
    Picked pick(const Eigen::Vector2f& at);
    void grab(const Picked& picked);
    void drag(const Eigen::Vector2f& at);
    void throwAway(const Picked& picked, float speed);
    void throwBall(const Eigen::Vector2f& at, float speed);
    void push(const Input& input);
    bool hasBall();
    void change(const Change& made);
    void reset();
    void restart(const std::vector<std::string>& sets);
    void advance(uint32_t steps);
    void step();
    void pull();
    void drawIfDue();
    double allowedShare() const;
    void measure();
    void tellFigures();

    Gpu& gpu_;
    const LoadServed& load_;
    LiveFeed& feed_;
    PictureShare share_;
    std::unique_ptr<ShownScene> shown_;
    std::vector<std::string> sets_;     ///< Of restarts so far.
    std::optional<FreeCamera> camera_;  ///< Of viewers; none: the scene's own.
    std::optional<ChangeLog> log_;
    Pace pace_;
    Rate pictures_;
    uint64_t version_ = 1, drawn_ = 0;  ///< Of what a picture shows; of the last picture.
    std::optional<uint64_t> measured_;  ///< Steps at the last measure.
    Measures measures_;
    std::string message_;  ///< What was refused of late.
    Clock::time_point steered_, dragged_, drawStarted_, nextFigures_, nextMeasure_;
};

}  // namespace knuckle
