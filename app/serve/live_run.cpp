#include "app/serve/live_run.h"

#include <fmt/format.h>

#include "app/run/interrupt.h"
#include "app/run/tell.h"
#include "app/serve/live_loop.h"
#include "app/serve/web/page.h"
#include "sim/base/fnv_hash.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

void tellAddress(const std::string& scene, const WebServer& server, const WebOptions& web)
{
    const bool bare = web.host.find(':') == std::string::npos;
    fmt::print("{} is shown at http://{}:{}/{}; Ctrl-C ends it\n", scene, bare ? web.host : "[" + web.host + "]",
               server.port(), web.token.empty() ? "" : "?token=TEXT");
    flushStandardOutput();
}

}  // namespace

void serveScene(const LoadServed& load, const ServeOptions& options, const CommonOptions& common)
{
    auto served = load({});
    const std::string name = served->scene.name;
    LiveFeed feed;
    // Before all that takes long: who mistypes a port learns it at once.
    const WebServer server(options.web, livePage(name), feed);
    const auto gpu = openGpu(
        common, FrameWork{stepWorkload(served->scene.world), drawingWorkload(liveSettings(served->scene))});
    LiveLoop loop(*gpu, load, std::move(served), feed, options);
    const InterruptGuard guard;
    if (!common.quiet) tellAddress(name, server, options.web);
    while (!guard.isSignalled()) loop.turn();
    loop.finish();
    if (options.hash) fmt::print("state hash {}\n", hashText(loop.stateHash()));
    throw Interrupted{};
}

}  // namespace knuckle
