#include "app/film/moments.h"

#include <algorithm>

namespace knuckle {

std::vector<Moment> momentsBefore(const Scene& scene, uint64_t frame)
{
    std::vector<Moment> moments;
    if (scene.render.shutter == 0.0f) return moments;
    const double open = static_cast<double>(scene.render.shutter) / 360.0, last = scene.timeOf(frame);
    const double between = last - scene.timeOf(frame - 1);
    const std::vector<Shot>& shots = scene.render.shots;
    const double cut = shots.empty() ? 0.0 : shots[shotAt(shots, last)].from;
    const uint32_t draws = drawsOf(scene.render);
    for (uint32_t k = 0; k + 1 < draws; ++k) {
        const double before = open * (draws - 1 - k) / (draws - 1);
        moments.push_back({1.0 - before, std::max(last - before * between, cut)});
    }
    return moments;
}

std::optional<uint32_t> ownDraw(const Scene& scene, uint64_t frame, uint64_t first)
{
    if (scene.render.shutter == 0.0f || frame == first) return {};
    return drawsOf(scene.render) - 1;
}

}  // namespace knuckle
