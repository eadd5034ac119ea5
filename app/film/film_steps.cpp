#include "app/film/film_steps.h"

#include <stdexcept>

namespace knuckle {

namespace {

/// Steps of a frame after which it is checked whether any has to be taken again.
constexpr uint64_t CHECKED_STEPS = 16;

}  // namespace

FilmSteps::FilmSteps(const Gpu& gpu, const Scene& scene, Solver& solver) : scene_(scene), solver_(solver)
{
    if (!scene.clock.isEven() || scene.render.shutter > 0.0f)
        between_ = std::make_unique<BetweenSteps>(gpu, scene.world);
}

void FilmSteps::advance(uint64_t frame, const std::function<void()>& step)
{
    advance(frame, step, {});
}

ParticleView FilmSteps::viewAt(double place, uint64_t steps)
{
    const double part = place + 1.0 - static_cast<double>(steps);
    return part < 1.0 ? between_->at(solver_.view(), part) : solver_.view();
}

void FilmSteps::advance(uint64_t frame, const std::function<void()>& step, const ShowMoment& show)
{
    const FramePlace next = scene_.clock.at(frame);
    const auto placeOf = [](const FramePlace& at) { return static_cast<double>(at.steps) - 1.0 + at.part; };
    const double from = placeOf(place_), by = placeOf(next) - from;
    const std::vector<Moment> moments = show ? momentsBefore(scene_, frame) : std::vector<Moment>();
    uint32_t shown = 0;
    const auto isBefore = [&](uint64_t steps) {
        return shown < moments.size() && from + moments[shown].place * by <= static_cast<double>(steps);
    };
    const auto showUpTo = [&](uint64_t steps) {
        for (; isBefore(steps); ++shown) show(viewAt(from + moments[shown].place * by, steps), moments[shown], shown);
    };
    showUpTo(place_.steps);
    for (uint64_t taken = place_.steps; taken < next.steps; ++taken) {
        const bool shows = isBefore(taken + 1);
        if (shows || (taken + 1 == next.steps && next.part < 1.0)) {
            solver_.checkCounters(frame);  // steps that have to be repeated must not be drawn
            between_->begin(solver_.view());
        }
        step();
        const bool isMany = (taken + 1 - place_.steps) % CHECKED_STEPS == 0;  // few have to be taken again
        if (shows || isMany) solver_.checkCounters(frame);
        showUpTo(taken + 1);
    }
    place_ = next;
}

ParticleView FilmSteps::view()
{
    return isBetween() ? between_->at(solver_.view(), place_.part) : solver_.view();
}

ViewState FilmSteps::readView()
{
    ViewState view = solver_.readView();
    if (!isBetween()) return view;
    between_->at(solver_.view(), place_.part);
    between_->read(view);
    return view;
}

uint64_t FilmSteps::stateHash()
{
    return isBetween() ? knuckle::stateHash(readView()) : solver_.stateHash();
}

std::optional<BufferState> FilmSteps::saveState() const
{
    if (!isBetween()) return {};
    return between_->saveState();
}

void FilmSteps::goOn(uint64_t frame, const std::optional<BufferState>& state)
{
    place_ = scene_.clock.at(frame);
    if (!isBetween()) return;
    if (!state) throw std::logic_error("the state has nothing of the step before");
    between_->loadState(*state);
}

}  // namespace knuckle
