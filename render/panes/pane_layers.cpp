#include <stdexcept>

#include "render/panes/pane_impl.h"

namespace knuckle {

void Pane::Impl::drawLayers(const ParticleView& drawn, double time, bool wanted)
{
    if (!layers) throw std::logic_error("the pane was made for pictures");
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_DEPTH_CLAMP);
    attach(drawn);
    aimCamera(time, 0);
    lists.update(timer);
    skins.update(timer);
    surfaces.update(timer);
    ropes.update(timer);
    if (wanted) {
        drawGeometry(true, true);
        if (!fluids.empty()) fluids.drawLayer(timer, lists);
        layers->draw(timer);
    }
    skins.endFrame();
    surfaces.endFrame();
    ropes.endFrame();
}

LayerCamera Pane::lookForLayers(const ParticleView& view, double time)
{
    impl_->drawLayers(view, time, false);
    return camera();
}

Layers Pane::drawLayers(const ParticleView& view, double time)
{
    impl_->drawLayers(view, time, true);
    return impl_->layers->read(impl_->view.read(), impl_->input.tanHalfFov);
}

}  // namespace knuckle
