#include "render/view/view_passes.h"

namespace knuckle {

ViewPasses::ViewPasses(const Gpu& gpu, BufferTable& table, bool hasUnseen, bool hasFramed, bool hasSolids)
{
    Defines defines;
    if (hasUnseen) defines.push_back({"UNSEEN", "1"});
    if (hasFramed) defines.push_back({"FRAMED", "1"});
    table.add(Lifetime::State, view_);  // for an automatic camera, whose place follows from its last one
    table.add(Lifetime::Scratch, boxes_);
    bounds_ = Kernel(gpu, table, "render/view/frame_bounds.comp", defines);
    Defines ofCamera = hasSolids ? Defines{{"SOLIDS", "1"}} : Defines{};
    if (hasFramed) ofCamera.push_back({"FRAMED", "1"});
    camera_ = Kernel(gpu, table, "render/view/frame_camera.comp", ofCamera);
    fit_ = Kernel(gpu, table, "render/view/frame_view.comp");
}

void ViewPasses::aim(KernelTimer& timer) const
{
    bounds_.dispatch(timer, BOUNDS_THREADS / RENDER_GROUP_SIZE);
    camera_.dispatch(timer, 1);
}

void ViewPasses::fit(KernelTimer& timer) const
{
    fit_.dispatch(timer, 1);
}

}  // namespace knuckle
