#include "app/golden/golden_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/files/assets.h"
#include "app/film/complete_picture.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

Scene loadGoldenScene(const Golden& golden, const std::vector<Override>& changes)
{
    std::vector<Override> all = golden.changes;
    all.insert(all.end(), changes.begin(), changes.end());
    Scene scene = loadScene(findAsset(golden.scene), all);
    completePicture(scene);
    if (scene.start)
        failAt(golden.scene, "/start", "goes on from a run's states, which goldens do not have; take it away");
    // The triangles of coarse levels depend on a library's version.
    scene.render.skinError = 0.0f;
    if (golden.frames.back() > scene.frameCount())
        throw InputError(fmt::format("{}: /frames: {} is beyond the scene's last frame, {}; name others", golden.path(),
                                     golden.frames.back(), scene.frameCount()));
    return scene;
}

}  // namespace

GoldenScene::GoldenScene(const Golden& golden, const std::vector<Override>& changes, Gpu& gpu,
                         const InterruptGuard& interrupt)
    : scene_(loadGoldenScene(golden, changes)), gpu_(gpu), stored_(scene_.world), interrupt_(interrupt)
{
}

RunFacts GoldenScene::facts(const Golden& golden) const
{
    // Not by its path from here, so that the file's bytes do not depend on the folder in which the program runs.
    return factsOf(scene_, gpu_, {golden.document["scene"], golden.changes});
}

void GoldenScene::simulate(const std::vector<uint64_t>& frames, bool withCamera,
                           const std::function<void(const Simulated&)>& show)
{
    Solver solver(gpu_, scene_.world);
    FilmSteps steps(gpu_, scene_, solver);
    std::optional<Renderer> camera;
    if (withCamera) camera.emplace(gpu_, scene_.world, scene_.render);
    auto next = frames.begin();
    for (uint64_t frame = 1; next != frames.end(); ++frame) {
        if (frame > 1) steps.advance(frame, [&] { solver.step(); });
        if (frame > 1) solver.checkCounters(frame);
        if (frame == *next) {
            show({frame, steps, camera ? &*camera : nullptr});
            ++next;
        }
        if (camera) camera->look(steps.view(), scene_.timeOf(frame));
        interrupt_.check();
    }
    gpu_.checkErrors();
}

std::string GoldenScene::otherWorld(const ViewState& stored) const
{
    const World& world = scene_.world;
    std::vector<std::string> others;
    const auto compare = [&](const char* what, size_t now, size_t then) {
        if (now != then) others.push_back(fmt::format("{} {}, not {}", now, what, then));
    };
    compare("particles", world.particles.size(), stored.positions.size());
    compare("bodies", world.bodies.size(), stored.bodyCentres.size());
    compare("colliders", world.colliders.size(), stored.colliderPlaces.size() / 2);
    if (others.empty()) return {};
    return fmt::format("the stored state cannot be drawn: the scene has {}", fmt::join(others, ", "));
}

Image GoldenScene::draw(const StoredFrame& frame)
{
    return draw(frame, frame.view);
}

Image GoldenScene::draw(const StoredFrame& frame, const ViewState& view)
{
    const World& world = scene_.world;
    if (const std::string other = otherWorld(view); !other.empty()) throw InputError(other);
    if (!renderer_) renderer_.emplace(gpu_, world, scene_.render);
    renderer_->loadState(frame.camera);
    renderer_->draw(stored_.upload(view), scene_.timeOf(frame.number));
    Image image = renderer_->readImage();
    gpu_.checkErrors();
    interrupt_.check();
    return image;
}

}  // namespace knuckle
