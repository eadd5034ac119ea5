#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>

#include "app/bench/bench_run.h"
#include "render/renderer.h"

namespace knuckle {

/// Draws `frames` frames by each of the renderers in turn, so that a machine that changes its speed affects all alike.
/// A frame before them, which compiles, does not count. @param advance is called before each frame, with its number.
/// @returns median milliseconds of each.
inline std::vector<double> timeDrawing(std::span<Renderer> renderers, const Solver& solver, uint32_t frames,
                                       double timeStep, const std::function<void(uint32_t)>& advance)
{
    std::vector<std::vector<double>> milliseconds(renderers.size());
    const InterruptGuard interrupt;
    for (uint32_t frame = 0; frame <= frames; ++frame) {
        interrupt.check();
        advance(frame);
        glFinish();
        for (size_t i = 0; i < renderers.size(); ++i) {
            const auto start = std::chrono::steady_clock::now();
            renderers[i].draw(solver.view(), frame * timeStep);
            glFinish();
            if (frame > 0) milliseconds[i].push_back(1e3 * secondsSince(start));
        }
    }
    std::vector<double> medians;
    for (const std::vector<double>& times : milliseconds) medians.push_back(medianOf(times));
    return medians;
}

/// Runs the benchmark for each number of objects and prints its rows below a heading, or JSON. @param runOnce makes a
/// run, which has toJson() and printRow(). @returns the exit code.
template <typename RunOnce>
int reportDrawing(const BenchOptions& options, Gpu& gpu, const std::string& heading, RunOnce runOnce)
{
    if (!options.json) fmt::print("{}", heading);
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const uint32_t objectCount : options.objects) {
        const auto run = runOnce(gpu, objectCount, options);
        if (options.json) runs.push_back(toJson(run));
        else printRow(run);
    }
    if (options.json) fmt::print("{}\n", runsToJson(options, gpu, 0, std::move(runs)).dump(2));
    return EXIT_FINE;
}

}  // namespace knuckle
