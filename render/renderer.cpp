#include "render/renderer.h"

#include <stdexcept>
#include <utility>

#include "render/view/framed_sets.h"

namespace knuckle {

Workload drawingWorkload(const RenderSettings& settings)
{
    // The passes of a simple picture; a pixel of it takes 0.11 us on one core of 2.6 GHz.
    const double samples = static_cast<double>(settings.antialiasing) * settings.antialiasing;
    const DrawnSize size = drawnSize(settings);
    return {8.0, 1.1e-4 * size.width * size.height * samples * drawsOf(settings)};
}

Renderer::Renderer(Gpu& gpu, const World& world, const RenderSettings& settings)
    : shots_(shotsOf(settings)), plans_(planPanes(settings)), overlay_(world, settings)
{
    for (const PanePlan& plan : plans_) panes_.push_back(std::make_unique<Pane>(gpu, world, plan.settings, timer_));
}

std::vector<Pane*> Renderer::panesAt(double time) const
{
    const Shot& shot = shots_[shotAt(shots_, time)];
    std::vector<Pane*> panes;
    for (size_t k = 0; k < panes_.size(); ++k)
        if (isShown(plans_[k].place, shot)) panes.push_back(panes_[k].get());
    return panes;
}

void Renderer::draw(const ParticleView& view, double time)
{
    time_ = time;
    for (Pane* pane : panesAt(time)) pane->draw(view, time);
}

void Renderer::expose(const ParticleView& view, double time, uint32_t draw)
{
    time_ = time;
    for (Pane* pane : panesAt(time)) pane->expose(view, time, draw);
}

void Renderer::look(const ParticleView& view, double time)
{
    time_ = time;
    for (Pane* pane : panesAt(time)) pane->look(view, time);
}

void Renderer::setCamera(const Eigen::Vector3f& position, const Eigen::Vector3f& target)
{
    for (const auto& pane : panes_) pane->setCamera(position, target);
}

Image Renderer::readImage()
{
    const Shot& shot = shots_[shotAt(shots_, time_)];
    const std::vector<Pane*> panes = panesAt(time_);
    Image image = panes[0]->readImage();
    if (shot.layout == PictureLayout::Inset) placeInset(image, panes[1]->readImage(), shot.insetAt);
    if (shot.layout == PictureLayout::Beside) image = besideEachOther(image, panes[1]->readImage());
    if (!overlay_.empty()) overlay_.draw(image, time_, overlay_.hasScaleBar() ? panes[0]->pixelsPerMetre() : 0.0f);
    return image;
}

RendererState Renderer::saveState() const
{
    RendererState state;
    for (size_t k = 0; k < panes_.size(); ++k) {
        RendererState own = panes_[k]->saveState();
        state.lookedAt = std::max(state.lookedAt, own.lookedAt);
        for (auto& [name, bytes] : own.buffers) state.buffers[wordOf(plans_[k].place) + name] = std::move(bytes);
    }
    return state;
}

void Renderer::loadState(const RendererState& state)
{
    // A pane that the shot at that time does not have begins anew with the next one.
    std::vector<RendererState> own(panes_.size(), RendererState{state.lookedAt, {}});
    for (const auto& [name, bytes] : state.buffers) {
        const size_t slash = name.find('/');
        const std::string word = slash == std::string::npos ? "" : name.substr(0, slash + 1);
        size_t k = 0;
        while (k < panes_.size() && wordOf(plans_[k].place) != word) ++k;
        if (k == panes_.size()) throw std::logic_error("the state is of pictures of other parts");
        own[k].buffers[name.substr(word.size())] = bytes;
    }
    const RendererState before = saveState();
    try {
        for (size_t k = 0; k < panes_.size(); ++k) panes_[k]->loadState(own[k]);
    } catch (const std::logic_error&) {
        if (panes_.size() > 1) loadState(before);
        throw;
    }
    time_ = state.lookedAt.value_or(0.0);
}

}  // namespace knuckle
