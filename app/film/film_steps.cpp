#include "app/film/film_steps.h"

#include <stdexcept>

namespace knuckle {

FilmSteps::FilmSteps(const Gpu& gpu, const Scene& scene, Solver& solver) : scene_(scene), solver_(solver)
{
    if (!scene.clock.isEven()) between_ = std::make_unique<BetweenSteps>(gpu, scene.world);
}

void FilmSteps::advance(uint64_t frame, const std::function<void()>& step)
{
    const FramePlace next = scene_.clock.at(frame);
    for (uint64_t taken = place_.steps; taken < next.steps; ++taken) {
        if (taken + 1 == next.steps && next.part < 1.0) {
            solver_.checkCounters(frame);  // steps that have to be repeated must not be drawn
            between_->begin(solver_.view());
        }
        step();
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
