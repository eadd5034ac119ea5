#include "app/golden/state_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>

#include "app/run/counted.h"
#include "render/compare/verdict.h"
#include "sim/base/angles.h"
#include "sim/base/no_index.h"

namespace knuckle {

namespace {

/// Places of loose particles are stored in steps of up to 1/256 of a diameter: half of one, along three axes.
constexpr double ROUNDING = 0.0034;
/// A collider of some ten diameters moves its rim by a diameter when it turns by so much [radians].
constexpr double TURN_A_DIAMETER = 0.1;

/// "object "ball"", or the material of a loose particle.
std::string ownerOf(const World& world, size_t particle)
{
    const Particle& p = world.particles[particle];
    if (p.body == NO_INDEX) return fmt::format("\"{}\"", world.materials[p.material].name);
    const Body& body = world.bodies[p.body];
    return fmt::format("\"{}\"", body.object == NO_INDEX ? body.name : world.objects[body.object].name);
}

double distance(const gpu::vec4& a, const gpu::vec4& b)
{
    return double{(Vector3f(a.x, a.y, a.z) - Vector3f(b.x, b.y, b.z)).norm()};
}

/// @returns radians.
double angleBetween(const gpu::vec4& p, const gpu::vec4& q)
{
    return double{Quaternionf(p.w, p.x, p.y, p.z).angularDistance(Quaternionf(q.w, q.x, q.y, q.z))};
}

bool sameBits(const gpu::vec4& a, const gpu::vec4& b)
{
    return std::bit_cast<std::array<uint32_t, 4>>(a) == std::bit_cast<std::array<uint32_t, 4>>(b);
}

class StateComparison {
public:
    StateComparison(const World& world, double limit) : world_(world), limit_(std::max(limit, ROUNDING)) {}

    void add(const gpu::vec4& stored, const gpu::vec4& now, size_t particle)
    {
        bool moved = stored.w != now.w;
        if (moved) ++difference.cameOrWent;
        else if (now.w == 0.0f) moved = isFar(stored, now, particle);
        Counts& counts = owners_[ownerOf(world_, particle)];
        ++counts.all;
        if (!moved) return;
        ++counts.moved;
        ++difference.moved;
    }

    StateDifference finish()
    {
        if (seen_ > 0) difference.mean /= static_cast<double>(seen_);
        difference.owner = ownerOf(world_, difference.farthest);
        for (const auto& [owner, counts] : owners_) {
            if (counts.moved <= difference.mostMoved) continue;
            difference.most = owner;
            difference.mostMoved = counts.moved;
            difference.mostCount = counts.all;
        }
        return difference;
    }

    StateDifference difference;

private:
    struct Counts {
        uint64_t moved = 0, all = 0;
    };

    bool isFar(const gpu::vec4& stored, const gpu::vec4& now, size_t particle)
    {
        const double far = distance(stored, now) / double{world_.diameter()};
        ++seen_;
        difference.mean += far;
        if (!(far <= difference.largest)) {
            difference.largest = far;
            difference.farthest = static_cast<uint32_t>(particle);
            difference.place = {now.x, now.y, now.z};
        }
        return !(far <= limit_);  // what is no number as well
    }

    const World& world_;
    double limit_;
    uint64_t seen_ = 0;
    std::map<std::string, Counts> owners_;
};

}  // namespace

bool StateDifference::isWithin(const StateLimits& limits) const
{
    if (sameBits) return true;
    if (!sameKind || limits.distance == 0.0) return false;
    return static_cast<double>(moved) <= limits.share * static_cast<double>(particles) && torn == 0 &&
           colliders <= limits.distance && turned <= limits.distance * TURN_A_DIAMETER;
}

bool sameColliders(const ViewState& stored, const ViewState& now)
{
    return std::ranges::equal(stored.colliderPlaces, now.colliderPlaces, sameBits);
}

StateDifference compareStates(const World& world, const ViewState& stored, const ViewState& now,
                              const StateLimits& limits)
{
    StateComparison comparison(world, limits.distance);
    StateDifference& difference = comparison.difference;
    difference.sameBits = false;
    difference.particles = now.positions.size();
    difference.storedParticles = stored.positions.size();
    difference.sameKind = difference.particles == difference.storedParticles &&
                          stored.bodyCentres.size() == now.bodyCentres.size() &&
                          stored.colliderPlaces.size() == now.colliderPlaces.size();
    if (!difference.sameKind) return difference;
    for (size_t p = 0; p < now.positions.size(); ++p) comparison.add(stored.positions[p], now.positions[p], p);
    const auto isTorn = [](const ViewState& view, size_t p) { return p < view.torn.size() && view.torn[p]; };
    for (size_t p = 0; p < now.positions.size(); ++p) difference.torn += isTorn(stored, p) != isTorn(now, p) ? 1 : 0;
    for (size_t c = 0; c < now.colliderPlaces.size(); c += 2) {
        difference.colliders = std::max(
            difference.colliders, distance(stored.colliderPlaces[c], now.colliderPlaces[c]) / double{world.diameter()});
        difference.turned = std::max(difference.turned,
                                     angleBetween(stored.colliderPlaces[c + 1], now.colliderPlaces[c + 1]));
    }
    return comparison.finish();
}

std::string differenceWords(const StateDifference& difference, const StateLimits& limits)
{
    if (difference.sameBits) return "the same bits";
    if (!difference.sameKind) {
        if (difference.particles == difference.storedParticles)
            return fmt::format("it has other bodies or colliders than the stored state, of {} as well",
                               counted(difference.particles, "particle"));
        return fmt::format("it has {}, the stored state {}", counted(difference.particles, "particle"),
                           difference.storedParticles);
    }
    std::string words;
    if (difference.moved == 0) {
        words = difference.sameParticles ? "particles have the same bits"
                : difference.largest < ROUNDING
                    ? "bits differ, of velocities or by roundings: all particles are where they were"
                    : fmt::format("bits differ, though all particles are within {} diameters of where they were",
                                  shortNumber(difference.largest));
    } else {
        words = fmt::format("{} of {} {} more than {} diameters from where they were, most of {} ({} of {})",
                            difference.moved, counted(difference.particles, "particle"),
                            difference.moved == 1 ? "is" : "are", shortNumber(std::max(limits.distance, ROUNDING)),
                            difference.most, difference.mostMoved, difference.mostCount);
        if (difference.largest > 0.0)
            words += fmt::format("; the farthest, particle {} of {}, by {} diameters, at {:.3g} {:.3g} {:.3g} m",
                                 difference.farthest, difference.owner, shortNumber(difference.largest),
                                 double{difference.place.x()}, double{difference.place.y()},
                                 double{difference.place.z()});
    }
    if (difference.cameOrWent > 0)
        words += fmt::format("; {} came or went", counted(difference.cameOrWent, "particle"));
    if (difference.torn > 0)
        words += fmt::format("; {} of joints torn in only one of them", counted(difference.torn, "particle"));
    if (difference.colliders > 0.0)
        words += fmt::format("; a collider is {} diameters from where it was", shortNumber(difference.colliders));
    if (difference.turned > 0.0)
        words += fmt::format("; a collider is turned by {} degrees",
                             shortNumber(degreesOf(static_cast<float>(difference.turned))));
    return words;
}

}  // namespace knuckle
