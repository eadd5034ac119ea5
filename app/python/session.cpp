#include "app/python/session.h"

#include <stdexcept>

#include "app/json/json.h"
#include "sim/gpu/device/thread_device.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

/// Steps between checks of lists: after an overflow, at most these are repeated.
constexpr uint32_t STEPS_A_CHECK = 8;

}  // namespace

Session::Session(std::shared_ptr<const Scene> scene, const std::string& device)
    : scene_(std::move(scene)), gpu_(deviceOfThread(device, FrameWork{stepWorkload(scene_->world), {}})),
      solver_(*gpu_, scene_->world)
{
}

Solver& Session::here()
{
    if (std::this_thread::get_id() != thread_)
        throw std::logic_error("a simulation belongs to the thread that made it, and this is another");
    return solver_;
}

void Session::step(uint32_t count)
{
    Solver& solver = here();
    for (uint32_t k = 1; k <= count; ++k) {
        solver.step();
        ++steps_;
        if (k == count || k % STEPS_A_CHECK == 0) solver.checkCounters(steps_);
    }
}

double Session::time() const
{
    return static_cast<double>(steps_) * static_cast<double>(scene_->world.settings.timeStep);
}

SessionState Session::save()
{
    return {steps_, here().saveState()};
}

void Session::load(const SessionState& state)
{
    here().loadState(state.solver);
    steps_ = state.steps;
}

RenderSettings Session::settingsFor(const PictureWish& wish) const
{
    // The scene is read again as the command line would change it: one place says what a picture may be.
    RenderSettings settings = scene_->render;
    if (!wish.camera.empty() || !wish.quality.empty()) {
        Json document = Json::parse(scene_->document);
        if (!wish.camera.empty()) {
            document["camera"] = Json::parse(wish.camera);
            document.erase("shots");
        }
        if (!wish.quality.empty()) document["render"]["quality"] = wish.quality;
        settings = loadStoredScene(scene_->file, document.dump()).render;
    }
    settings.width = wish.width;
    settings.height = wish.height;
    return settings;
}

Image Session::picture(const PictureWish& wish)
{
    const ParticleView view = here().view();
    std::unique_ptr<Renderer>& renderer = renderers_[wish];
    if (!renderer) renderer = std::make_unique<Renderer>(*gpu_, scene_->world, settingsFor(wish));
    renderer->draw(view, time());
    return renderer->readImage();
}

}  // namespace knuckle
