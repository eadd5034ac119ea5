#include <fmt/format.h>

#include <array>

#include "app/bench/bench_worlds.h"
#include "app/bench/draw_timing.h"
#include "sim/base/errors.h"
#include "sim/solver/workload.h"

namespace knuckle {

namespace {

constexpr int SIDE = 16;        // of a block, particles
constexpr uint32_t ACROSS = 4;  // blocks along x and z, before the next layer
constexpr float DIAMETER = 0.1f;

/// Milliseconds a frame, medians.
struct WaterRun {
    uint32_t blockCount = 0;
    size_t particleCount = 0;
    double bare = 0.0, spheres = 0.0, surface = 0.0;

    double ratio() const { return surface / spheres; }
};

/// Blocks of water side by side on the floor of the benchmarks' box.
World waterWorld(uint32_t blockCount, DrawnAs drawn)
{
    WorldBuilder builder(DIAMETER / 2);
    Material water;
    water.name = "water";
    water.fluid = true;
    water.color = {0.1f, 0.35f, 0.6f};
    water.look.drawn = drawn;
    const uint32_t material = builder.addMaterial(water);
    addBenchBox(builder);
    const float pitch = builder.fluidSpacing();
    for (uint32_t block = 0; block < blockCount; ++block) {
        const uint32_t layer = block / (ACROSS * ACROSS), place = block % (ACROSS * ACROSS);
        const uint32_t row = place / ACROSS;
        const Vector3f corner(static_cast<float>(place % ACROSS) - 0.5f * ACROSS, static_cast<float>(layer),
                              static_cast<float>(row) - 0.5f * ACROSS);
        std::vector<Vector3f> positions = boxLattice({SIDE, SIDE, SIDE}, pitch);
        for (Vector3f& p : positions) p += SIDE * pitch * (corner + Vector3f::Constant(0.5f));
        builder.addFluid(positions, Vector3f::Zero(), material);
    }
    return builder.build();
}

WaterRun runOnce(Gpu& gpu, uint32_t blockCount, const BenchOptions& options)
{
    const World surface = waterWorld(blockCount, DrawnAs::Surface),
                spheres = waterWorld(blockCount, DrawnAs::Particles);
    RenderSettings ofMaterials;
    ofMaterials.colorBy = ColorBy::Material;
    World bare = spheres;
    bare.unseen.push_back({0, static_cast<uint32_t>(bare.particles.size())});
    Solver solver(gpu, surface);
    solver.step();  // finds the forms that particles are drawn in
    std::array<Renderer, 3> renderers = {Renderer(gpu, bare, ofMaterials), Renderer(gpu, spheres, ofMaterials),
                                         Renderer(gpu, surface, ofMaterials)};
    const std::vector<double> times = timeDrawing(renderers, solver, options.drawnSteps,
                                                  static_cast<double>(surface.settings.timeStep), [](uint32_t) {});
    return {.blockCount = blockCount,
            .particleCount = surface.particles.size(),
            .bare = times[0],
            .spheres = times[1],
            .surface = times[2]};
}

nlohmann::ordered_json toJson(const WaterRun& run)
{
    return {{"blockCount", run.blockCount},       {"particleCount", run.particleCount},
            {"bareMilliseconds", run.bare},       {"spheresMilliseconds", run.spheres},
            {"surfaceMilliseconds", run.surface}, {"surfaceOverSpheres", run.ratio()}};
}

void printRow(const WaterRun& run)
{
    fmt::print("{:6}{:11}{:9.2f}{:9.2f}{:9.2f}{:19.2f}\n", run.blockCount, run.particleCount, run.bare, run.spheres,
               run.surface, run.ratio());
    std::fflush(stdout);
}

}  // namespace

int benchWater(const BenchOptions& options, const CommonOptions& common)
{
    if (options.drawnSteps == 0) throw InputError("bench water needs --drawn-steps of 1 or more");
    const uint32_t most = *std::max_element(options.objects.begin(), options.objects.end());
    const auto gpu = openGpu(common, FrameWork{stepWorkload(waterWorld(most, DrawnAs::Surface)), drawingWorkload({})});
    const std::string heading = fmt::format(
        "Water at rest on {}:\n"
        "ms a frame of 1280x720, the median of {}, with the water unseen, as spheres and as a surface.\n\n"
        "blocks  particles     bare  spheres  surface  surface / spheres\n",
        gpu->device().name, options.drawnSteps);
    return reportDrawing(options, *gpu, heading, runOnce);
}

}  // namespace knuckle
