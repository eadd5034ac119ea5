#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/serve/changes/change_log.h"
#include "app/serve/changes/live_world.h"
#include "app/serve/hand.h"
#include "app/serve/live_drawing.h"
#include "app/serve/served_scene.h"

namespace knuckle {

/// A scene that is simulated, drawn and touched. Another one takes its place when viewers change what cannot change
/// while it runs.
struct ShownScene {
    ShownScene(Gpu& gpu, std::unique_ptr<ServedScene> from, LiveFeed& feed)
        : served(std::move(from)), live(gpu, served->scene, served->branch.get()),
          drawing(gpu, served->scene, live.solver().view(), feed), hand(gpu, live.world(), liveSettings(served->scene))
    {
    }

    std::unique_ptr<ServedScene> served;
    LiveWorld live;
    LiveDrawing drawing;
    Hand hand;
};

}  // namespace knuckle
