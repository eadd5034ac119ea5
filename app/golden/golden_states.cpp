#include "app/golden/golden_states.h"

#include <algorithm>
#include <cmath>

#include "sim/base/no_index.h"

namespace knuckle {

namespace {

constexpr float STEPS_A_DIAMETER = 256.0f;

}  // namespace

void compact(ViewState& view, const Scene& scene)
{
    // A power of two, so that the last bits of all places are 0.
    const float step = std::exp2(std::floor(std::log2(scene.world.diameter() / STEPS_A_DIAMETER)));
    const auto rounded = [step](float value) { return std::round(value / step) * step; };
    for (size_t p = 0; p < view.positions.size(); ++p) {
        if (scene.world.particles[p].body != NO_INDEX) continue;
        gpu::vec4& place = view.positions[p];
        place = {rounded(place.x), rounded(place.y), rounded(place.z), place.w};
    }
    if (scene.render.colorBy != ColorBy::Speed) std::ranges::fill(view.velocities, gpu::vec4{});
}

void writeStoredFrames(const std::string& path, const Scene& scene, const RunFacts& facts,
                       const std::vector<StoredFrame>& frames)
{
    StatesWriter writer(path, scene, facts);
    for (const StoredFrame& frame : frames) {
        writer.addFrame(frame.number, frame.view);
        writer.addCamera(frame.number, frame.camera);
    }
    writer.commit();
}

StoredFrames::StoredFrames(const std::string& path) : file_(path), coding_(file_.blocks(), file_.facts().bodies) {}

StoredFrame StoredFrames::read(uint64_t frame) const
{
    return {frame, coding_.unpack(file_.blocks(), frame), unpackCamera(file_.blocks(), frame)};
}

}  // namespace knuckle
