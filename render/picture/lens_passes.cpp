#include "render/picture/lens_passes.h"

#include <algorithm>

#include "render/looks/picture_defines.h"

namespace knuckle {

namespace {

/// Share of the light of each size of blur that is of wider ones.
constexpr float OF_WIDER = 0.65f;
/// The last picture is so small, or after so many.
constexpr uint32_t SMALLEST = 12, MOST_LEVELS = 7;

}  // namespace

LensPasses::LensPasses(const Gpu& gpu, BufferTable& table, const RenderTargets& targets, const RenderSettings& settings)
{
    if (!hasLens(settings)) return;
    exposed_ = Texture("exposedPicture", GL_RGBA32F, settings.width, settings.height, GL_LINEAR);
    developed_ = Texture("developedPicture", settings.depth == 16 ? GL_RGBA16 : GL_RGBA8, settings.width,
                         settings.height);
    exposure_ = Framebuffer("exposure", {&exposed_}, nullptr);
    development_ = Framebuffer("development", {&developed_}, nullptr);
    table.add(exposed_);
    const std::string drawn = targets.resolved.id() != 0 ? targets.resolved.label() : targets.smoothed.label();
    const Defines covering = targets.isTransparent() ? Defines{{"TRANSPARENT", "1"}} : Defines{};
    expose_ = DrawPass(gpu, table, {"picture/screen", "picture/expose", joined({covering, {{"SOURCE", drawn}}})},
                       {drawn}, exposure_);
    expose_.setAdditive();
    if (settings.bloom > 0.0f) addLevels(gpu, table, settings);
    Defines looks = curveDefines(settings);
    if (!levels_.empty()) looks.push_back({"BLOOM", "1"});
    if (settings.quality == Quality::Final) looks.push_back({"DITHER", "1"});
    const DrawShaders shaders{"picture/screen", "picture/develop", looks};
    develop_ = levels_.empty() ? DrawPass(gpu, table, shaders, {"exposedPicture"}, development_)
                               : DrawPass(gpu, table, shaders, {"exposedPicture", "bloom1Picture"}, development_);
}

void LensPasses::addLevels(const Gpu& gpu, BufferTable& table, const RenderSettings& settings)
{
    levels_.reserve(MOST_LEVELS);  // the table refers to them
    std::string before = exposed_.label();
    uint32_t width = settings.width, height = settings.height;
    while (levels_.size() < MOST_LEVELS && (levels_.empty() || std::min(width, height) > SMALLEST)) {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        Level& level = levels_.emplace_back();
        const std::string name = "bloom" + std::to_string(levels_.size()) + "Picture";
        level.picture = Texture(name, GL_RGBA16F, width, height, GL_LINEAR);
        level.target = Framebuffer(name, {&level.picture}, nullptr);
        table.add(level.picture);
        level.down = DrawPass(gpu, table, {"picture/screen", "picture/bloom_down", {{"SOURCE", before}}}, {before},
                              level.target);
        before = name;
    }
    for (size_t k = 0; k + 1 < levels_.size(); ++k) {
        const std::string& narrower = levels_[k + 1].picture.label();
        levels_[k].up = DrawPass(gpu, table, {"picture/screen", "picture/bloom_up", {{"SOURCE", narrower}}}, {narrower},
                                 levels_[k].target);
        levels_[k].up.setOpacity(OF_WIDER);
    }
}

void LensPasses::develop(KernelTimer& timer) const
{
    for (const Level& level : levels_) level.down.drawScreen(timer);
    for (size_t k = levels_.size(); k-- > 1;) levels_[k - 1].up.drawScreen(timer);
    develop_.drawScreen(timer);
}

}  // namespace knuckle
