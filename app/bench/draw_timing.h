#pragma once

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
    for (std::vector<double>& times : milliseconds) {
        std::ranges::sort(times);
        medians.push_back(times[times.size() / 2]);
    }
    return medians;
}

}  // namespace knuckle
