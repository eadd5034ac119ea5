#include "render/layers/layer_renderer.h"

#include "render/panes/layout.h"

namespace knuckle {

LayerRenderer::LayerRenderer(Gpu& gpu, const World& world, const RenderSettings& settings)
    : pane_(gpu, world, planPanes(layerSettings(settings)).front().settings, timer_)
{
}

LayerCamera LayerRenderer::look(const ParticleView& view, double time)
{
    return pane_.lookForLayers(view, time);
}

Layers LayerRenderer::draw(const ParticleView& view, double time)
{
    return pane_.drawLayers(view, time);
}

}  // namespace knuckle
