#include "app/api/scene.h"

#include <utility>

#include "app/json/json.h"
#include "app/scene/scene_file.h"

namespace knuckle {

SceneWorld loadSceneWorld(const std::string& path, const std::vector<std::string>& changes)
{
    std::vector<Override> overrides;
    for (const std::string& text : changes) overrides.push_back(parseOverride(text));
    Scene scene = loadScene(path, overrides);
    if (scene.start)
        failAt(path, "/start", "goes on from a run's states, which only `knuckle render` can; take it away");
    return {scene.name,     scene.description,   std::move(scene.world), scene.framesPerSecond,
            scene.duration, scene.stepsPerFrame, std::move(scene.notes)};
}

}  // namespace knuckle
