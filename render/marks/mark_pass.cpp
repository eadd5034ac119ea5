#include "render/marks/mark_pass.h"

#include "shared/draw_types.h"

namespace knuckle {

namespace {

constexpr float FAN_OPACITY = 0.26f;

std::vector<gpu::vec4> allOf(const Marks& marks)
{
    std::vector<gpu::vec4> corners = marks.fans;
    corners.insert(corners.end(), marks.lines.begin(), marks.lines.end());
    return corners;
}

}  // namespace

MarkPass::MarkPass(const Gpu& gpu, BufferTable& table, const Marks& marks, const RenderTargets& targets,
                   const Defines& shown)
    : corners_("markCorners", allOf(marks)), fanCorners_(static_cast<uint32_t>(marks.fans.size() / MARK_TEXELS)),
      lineCorners_(static_cast<uint32_t>(marks.lines.size() / MARK_TEXELS))
{
    if (corners_.size() == 0) return;
    table.add(Lifetime::Constant, corners_);
    const auto pass = [&] {
        return DrawPass(gpu, table, {"marks/mark", "marks/mark", shown},
                        {"markCorners", "bodyCentres", "bodyRotations"}, targets.lighting);
    };
    fans_ = pass();
    fans_.setOpacity(FAN_OPACITY);
    lines_ = pass();
}

void MarkPass::draw(KernelTimer& timer) const
{
    fans_.draw(timer, GL_TRIANGLES, fanCorners_);
    lines_.draw(timer, GL_TRIANGLES, lineCorners_, 1, fanCorners_);
}

}  // namespace knuckle
