#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/bench/draw_timing.h"
#include "app/bench/troupe_world.h"
#include "sim/base/errors.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

/// Milliseconds a frame, medians.
struct DrawRun {
    uint32_t actorCount = 0;
    size_t particleCount = 0, triangleCount = 0;
    double bare = 0.0, spheres = 0.0, skins = 0.0;

    /// The cost of figures in their skins, over their cost as spheres.
    double ratio() const { return (skins - bare) / (spheres - bare); }
};

World withoutSkins(World world)
{
    world.skins.clear();
    return world;
}

/// Figures that are simulated but not drawn.
World withoutFigures(World world)
{
    for (Skin& skin : world.skins) skin.mesh = std::make_shared<const SkinMesh>();
    return world;
}

DrawRun runOnce(Gpu& gpu, uint32_t actorCount, const BenchOptions& options)
{
    const World world = crowdWorld(actorCount, options.model), spheres = withoutSkins(world),
                bare = withoutFigures(world);
    Solver solver(gpu, world);
    std::array<Renderer, 3> renderers = {Renderer(gpu, bare, {}), Renderer(gpu, spheres, {}), Renderer(gpu, world, {})};
    const std::vector<double> times = timeDrawing(renderers, solver, options.drawnSteps,
                                                  static_cast<double>(world.settings.timeStep), [&](uint32_t frame) {
                                                      solver.step();
                                                      solver.checkCounters(frame + 1);
                                                  });
    return {.actorCount = actorCount,
            .particleCount = world.particles.size(),
            .triangleCount = world.skins[0].mesh->triangles.size(),
            .bare = times[0],
            .spheres = times[1],
            .skins = times[2]};
}

nlohmann::ordered_json toJson(const DrawRun& run)
{
    return {{"actorCount", run.actorCount},       {"particleCount", run.particleCount},
            {"triangleCount", run.triangleCount}, {"bareMilliseconds", run.bare},
            {"spheresMilliseconds", run.spheres}, {"skinsMilliseconds", run.skins},
            {"skinsOverSpheres", run.ratio()}};
}

void printRow(const DrawRun& run)
{
    fmt::print("{:6}{:11}{:11}{:9.2f}{:9.2f}{:9.2f}{:17.2f}\n", run.actorCount, run.particleCount, run.triangleCount,
               run.bare, run.spheres, run.skins, run.ratio());
    std::fflush(stdout);
}

}  // namespace

int benchDraw(const BenchOptions& options, const CommonOptions& common)
{
    if (options.drawnSteps == 0) throw InputError("bench draw needs --drawn-steps of 1 or more");
    const uint32_t most = *std::max_element(options.objects.begin(), options.objects.end());
    const auto gpu = openGpu(common, FrameWork{stepWorkload(crowdWorld(most, options.model)), drawingWorkload({})});
    const std::string heading = fmt::format(
        "A crowd on {}:\n"
        "ms a frame of 1280x720, the median of {}, with the figures unseen, as spheres and in\n"
        "their skins; and what skins cost of what spheres cost.\n\n"
        "actors  particles  triangles     bare  spheres    skins  skins / spheres\n",
        gpu->device().name, options.drawnSteps);
    return reportDrawing(options, *gpu, heading, runOnce);
}

}  // namespace knuckle
