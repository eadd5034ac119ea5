#pragma once

#include <atomic>

#include "app/serve/web/inbox.h"
#include "app/serve/web/latest.h"

namespace knuckle {

/// What passes between the thread that simulates and those that serve.
struct LiveFeed {
    Latest frame;    ///< JPEG.
    Latest figures;  ///< JSON.
    Inbox inbox;
    std::atomic<int> viewers = 0;    ///< Who look at pictures.
    std::atomic<int> listeners = 0;  ///< Who read figures.
};

}  // namespace knuckle
