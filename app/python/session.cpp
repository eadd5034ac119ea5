#include "app/python/session.h"

#include "app/json/json.h"
#include "sim/base/errors.h"
#include "sim/world/fingerprint/fingerprint.h"

namespace knuckle {

namespace {

/// Kept for pictures of the same wish; a camera that is moved by hand makes a new one each time.
constexpr size_t MOST_RENDERERS = 8;

/// The renderer of a wish, made if there is none.
template <typename T, typename Make>
T& rendererOf(std::map<PictureWish, std::unique_ptr<T>>& renderers, const PictureWish& wish, const Make& make)
{
    if (renderers.size() >= MOST_RENDERERS && !renderers.contains(wish))
        std::erase_if(renderers, [](const auto& entry) { return !entry.first.camera.empty(); });
    std::unique_ptr<T>& renderer = renderers[wish];
    if (!renderer) renderer = make();
    return *renderer;
}

}  // namespace

Session::Session(std::shared_ptr<const Scene> scene, const std::string& device)
    : scene_(std::move(scene)), solver_(scene_->world, device), things_(scene_->world)
{
}

uint64_t Session::worldMark()
{
    if (!worldMark_) worldMark_ = fingerprint(scene_->world);
    return *worldMark_;
}

SessionState Session::save()
{
    return {solver_.steps(), worldMark(), solver_.here().saveState()};
}

void Session::load(const SessionState& state)
{
    solver_.here();
    if (state.world != worldMark())
        throw InputError("the state is of another scene, or of another seed; load one that this scene's saved");
    solver_.load(state.solver, state.steps);
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
    const ParticleView view = solver_.here().view();
    Renderer& renderer = rendererOf(
        renderers_, wish, [&] { return std::make_unique<Renderer>(solver_.gpu(), scene_->world, settingsFor(wish)); });
    renderer.draw(view, time());
    return renderer.readImage();
}

Layers Session::layers(const PictureWish& wish)
{
    const ParticleView view = solver_.here().view();
    LayerRenderer& renderer = rendererOf(layerRenderers_, wish, [&] {
        return std::make_unique<LayerRenderer>(solver_.gpu(), scene_->world, settingsFor(wish));
    });
    return renderer.draw(view, time());
}

}  // namespace knuckle
