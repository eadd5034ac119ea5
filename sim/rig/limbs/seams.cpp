#include "sim/rig/limbs/seams.h"

#include "sim/world/space/cells.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float GAP = 0.9f;  // d: the grid's particle stays if none is this near

/// The particles so far, by place.
class Crowd {
public:
    explicit Crowd(float diameter) : diameter_(diameter), cells_(diameter) {}

    void add(const Vector3f& place, uint32_t body)
    {
        cells_.add(place, static_cast<uint32_t>(members_.size()));
        members_.emplace_back(place, body);
    }
    /// Whether a particle of another body is nearer than `reach` (at most 1) diameters; NO_INDEX: of any.
    bool isNear(const Vector3f& place, float reach, uint32_t body = NO_INDEX) const
    {
        bool near = false;
        cells_.forEachAround(place, [&](uint32_t i) {
            const auto& [other, itsBody] = members_[i];
            near = near || (itsBody != body && (other - place).norm() < reach * diameter_);
        });
        return near;
    }

private:
    float diameter_;
    Cells cells_;
    std::vector<std::pair<Vector3f, uint32_t>> members_;
};

}  // namespace

void fitSeams(const std::vector<BodyDraft>& drafts, const Voxels& grid, LimbPlaces& places)
{
    Crowd crowd(grid.diameter);
    std::vector<uint32_t> limbs;
    for (uint32_t b = 0; b < drafts.size(); ++b) {
        if (!places[b].empty()) limbs.push_back(b);
        else
            for (const uint32_t p : drafts[b].particles) crowd.add(grid.positions[p], b);
    }
    for (const uint32_t b : limbs) {
        std::erase_if(places[b], [&](const Vector3f& place) { return crowd.isNear(place, CROWDED, b); });
        for (const Vector3f& place : places[b]) crowd.add(place, b);
    }
    for (const uint32_t b : limbs) {
        for (const uint32_t p : drafts[b].particles) {
            const Vector3f& place = grid.positions[p];
            if (crowd.isNear(place, GAP)) continue;
            places[b].push_back(place);
            crowd.add(place, b);
        }
    }
}

}  // namespace knuckle
