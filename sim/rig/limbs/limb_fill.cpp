#include "sim/rig/limbs/limb_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/rig/limbs/limb_frame.h"
#include "sim/rig/limbs/limb_owner.h"
#include "sim/rig/limbs/seams.h"
#include "sim/world/space/cells.h"

namespace knuckle {

using Eigen::Vector3f;
using Places = std::vector<Vector3f>;

namespace {

constexpr float ALIKE = 0.5f;         // d: difference of distances to the surface of two mirrored particles
constexpr float BETTER = 0.95f;       // of the grid's surface error, to be better
constexpr float AWAY = 0.5f;          // d: distance from joints, where other bodies are part of the surface
constexpr size_t MOST_SAMPLES = 300;  // of a limb's surface

/// Parts that are filled along their bone if they are slender.
bool isLimb(BodyPart part)
{
    switch (part) {
        case BodyPart::UpperArm:
        case BodyPart::Forearm:
        case BodyPart::Hand:
        case BodyPart::Finger:
        case BodyPart::Thigh:
        case BodyPart::Shin:
        case BodyPart::Tail:
        case BodyPart::Wing:
        case BodyPart::Lever:
        case BodyPart::Other: return true;
        default: return false;
    }
}

/// The bodies of bones, particles and triangles of a figure.
class Bodies {
public:
    Bodies(const Figure& figure, const Solid& solid, const std::vector<BodyDraft>& drafts, const Voxels& voxels)
        : solid_(solid), voxels_(voxels), owner_(figure), cells_(voxels.diameter),
          ofParticle_(voxels.positions.size(), NO_INDEX), ofBone_(figure.tree.size(), NO_INDEX)
    {
        for (uint32_t p = 0; p < voxels.positions.size(); ++p) cells_.add(voxels.positions[p], p);
        for (uint32_t b = 0; b < drafts.size(); ++b) {
            for (const uint32_t p : drafts[b].particles) ofParticle_[p] = b;
            for (uint32_t bone = 0; bone < ofBone_.size(); ++bone)
                if (bone == drafts[b].bone || std::ranges::count(drafts[b].mergedBones, bone) > 0) ofBone_[bone] = b;
        }
    }
    uint32_t ofBone(uint32_t bone) const { return bone == NO_INDEX ? NO_INDEX : ofBone_[bone]; }
    uint32_t ofParticle(uint32_t particle) const { return ofParticle_[particle]; }
    uint32_t ofTriangle(uint32_t triangle) { return ofBone_[owner_.atMiddleOf(triangle)]; }

    /// Whether a place is in a body: by the skin, and next to one of its particles on the grid.
    bool holds(uint32_t body, const Vector3f& place)
    {
        bool beside = false;
        cells_.forEachAround(place, [&](uint32_t p) {
            beside = beside || (ofParticle_[p] == body && (voxels_.positions[p] - place).norm() < voxels_.diameter);
        });
        return beside && ofBone_[owner_.at(solid_.tree().nearestAround(place))] == body && solid_.inside(place);
    }

private:
    const Solid& solid_;
    const Voxels& voxels_;
    LimbOwner owner_;
    Cells cells_;
    std::vector<uint32_t> ofParticle_, ofBone_;
};

/// Points of each body's surface.
std::vector<Places> surfaces(const Solid& solid, Bodies& bodies, size_t count, float diameter)
{
    std::vector<Places> surface(count);
    uint32_t last = NO_INDEX, body = NO_INDEX;
    solid.forEachSample(0.5f * diameter, std::numeric_limits<double>::infinity(),
                        [&](const Vector3f& point, const Vector3f&, uint32_t triangle) {
                            if (triangle != last) body = bodies.ofTriangle(triangle);
                            last = triangle;
                            if (body != NO_INDEX) surface[body].push_back(point);
                        });
    return surface;
}

/// Some of the points, those between a limb's joints.
Places between(const LimbFrame& frame, const Places& surface, float diameter)
{
    Places inner, some;
    for (const Vector3f& point : surface) {
        const float way = (point - frame.head).dot(frame.along());
        if (way > AWAY * diameter && way < frame.length() - AWAY * diameter) inner.push_back(point);
    }
    const size_t step = inner.size() / MOST_SAMPLES + 1;
    for (size_t i = 0; i < inner.size(); i += step) some.push_back(inner[i]);
    return some;
}

/// The places nearest to the skin among all patterns; none if the grid's are as good.
Places bestPlaces(const LimbFrame& frame, const Places& grid, const Places& surface, float diameter,
                  const std::function<bool(const Vector3f&)>& belongs)
{
    Places best;
    float least = BETTER * surfaceError(grid, surface, diameter);
    for (const SlicePattern& pattern : SLICE_PATTERNS) {
        Places places = limbPlaces(frame, pattern, diameter, belongs);
        const float error = places.empty() ? least : surfaceError(places, surface, diameter);
        if (error >= least) continue;
        least = error;
        best = std::move(places);
    }
    return best;
}

/// The side of a plane that all of a limb is on: 1, -1; 0 if it is on both.
float sideOf(const Places& grid, const MirrorPlane& plane)
{
    const auto isLeft = [&](const Vector3f& place) { return plane.distance(place) > 0.0f; };
    const auto left = std::ranges::count_if(grid, isLeft);
    return left == std::ssize(grid) ? 1.0f : left == 0 ? -1.0f : 0.0f;
}

/// The images of places, if these fit as well as the places do.
Places imagesOf(const Places& places, const Mirror& mirror, const Solid& solid, float diameter)
{
    Places images;
    for (const Vector3f& place : places) {
        const Vector3f image = mirror.plane.mirrored(place);
        if (std::abs(solid.signedDistance(image) - solid.signedDistance(place)) > ALIKE * diameter) return {};
        images.push_back(image);
    }
    return images;
}

/// Replaces the grid's particles of the bodies by the new places.
void replace(const Solid& solid, const Bodies& bodies, const LimbPlaces& places, std::vector<BodyDraft>& drafts,
             Voxels& voxels)
{
    std::vector<uint32_t> kept, bodyOf;
    for (uint32_t p = 0; p < voxels.positions.size(); ++p) {
        const uint32_t body = bodies.ofParticle(p);
        if (body != NO_INDEX && !places[body].empty()) continue;
        kept.push_back(p);
        bodyOf.push_back(body);
    }
    voxels = voxels.chosen(kept);
    for (uint32_t b = 0; b < drafts.size(); ++b) {
        drafts[b].particles.clear();
        for (const Vector3f& place : places[b]) {
            voxels.add(solid, place);
            bodyOf.push_back(b);
        }
    }
    for (uint32_t p = 0; p < bodyOf.size(); ++p)
        if (bodyOf[p] != NO_INDEX) drafts[bodyOf[p]].particles.push_back(p);
}

}  // namespace

void fillAlongBones(const Figure& figure, const Solid& solid, std::vector<BodyDraft>& drafts, Voxels& voxels)
{
    const std::optional<Mirror>& mirror = figure.mirror;
    const float d = voxels.diameter;
    Bodies bodies(figure, solid, drafts, voxels);
    const std::vector<Places> surface = surfaces(solid, bodies, drafts.size(), d);
    LimbPlaces places(drafts.size());
    std::vector<uint8_t> done(drafts.size(), 0);
    for (uint32_t b = 0; b < drafts.size(); ++b) {
        if (done[b] != 0 || !isLimb(figure.anatomy[drafts[b].bone].part)) continue;
        const std::optional<LimbFrame> frame = limbFrame(drafts, b, voxels, figure.forward,
                                                         limbEnd(figure, drafts[b].bone));
        if (!frame) continue;
        Places grid;
        for (const uint32_t p : drafts[b].particles) grid.push_back(voxels.positions[p]);
        const uint32_t image = mirror ? mirror->images[drafts[b].bone] : NO_INDEX;
        const float side = image == NO_INDEX || image == drafts[b].bone ? 0.0f : sideOf(grid, mirror->plane);
        places[b] = bestPlaces(*frame, grid, between(*frame, surface[b], d), d, [&](const Vector3f& place) {
            const bool beyond = side != 0.0f && side * mirror->plane.distance(place) < 0.5f * CROWDED * d;
            return !beyond && bodies.holds(b, place);
        });
        const uint32_t other = bodies.ofBone(image);
        if (other == NO_INDEX || other == b || drafts[other].bone != image) continue;
        const Places images = imagesOf(places[b].empty() ? grid : places[b], *mirror, solid, d);
        done[other] = !images.empty();
        if (!places[b].empty()) places[other] = images;
    }
    fitSeams(drafts, voxels, places);
    replace(solid, bodies, places, drafts, voxels);
}

}  // namespace knuckle
