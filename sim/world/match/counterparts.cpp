#include "sim/world/match/counterparts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace knuckle {

namespace {

/// Arms of bodies that differ by less than this are the same [diameters].
constexpr float SAME = 1e-3f;

/// Indices by name, in their order.
template <typename Things>
std::map<std::string, std::vector<uint32_t>> byName(const Things& things)
{
    std::map<std::string, std::vector<uint32_t>> indices;
    for (uint32_t i = 0; i < things.size(); ++i) indices[things[i].name].push_back(i);
    return indices;
}

/// Per thing of `after`, the first of that name in `before` that has none yet.
template <typename Things>
std::vector<uint32_t> sameNames(const Things& before, const Things& after)
{
    const auto earlier = byName(before);
    std::map<std::string, size_t> taken;
    std::vector<uint32_t> same;
    for (const auto& thing : after) {
        const auto found = earlier.find(thing.name);
        const size_t nth = taken[thing.name]++;
        same.push_back(found == earlier.end() || nth >= found->second.size() ? NO_INDEX : found->second[nth]);
    }
    return same;
}

class Matcher {
public:
    Matcher(const World& before, const World& after) : before_(before), after_(after)
    {
        found_.particles.assign(after.particles.size(), NO_INDEX);
        found_.bodies.assign(after.bodies.size(), NO_INDEX);
        found_.softBodies.assign(after.softBodies.size(), NO_INDEX);
    }

    Counterparts match()
    {
        matchObjects();
        matchGroups();
        matchStrands();
        matchEmitters();
        matchColliders();
        tellNames();
        return std::move(found_);
    }

private:
    using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;  // of particles: after, before

    void matchObjects()
    {
        const std::vector<uint32_t> same = sameNames(before_.objects, after_.objects);
        for (uint32_t o = 0; o < same.size(); ++o) {
            Pairs pairs;
            if (same[o] == NO_INDEX || !bodiesMatch(same[o], o, pairs) || !softMatch(same[o], o, pairs)) continue;
            objects_.insert(o);
            earlierObjects_.insert(same[o]);
            for (const auto& [later, earlier] : pairs) found_.particles[later] = earlier;
            const Object &then = before_.objects[same[o]], &now = after_.objects[o];
            for (uint32_t b = 0; b < now.bodyCount; ++b) found_.bodies[now.bodyStart + b] = then.bodyStart + b;
            for (const auto& [earlier, later] : softBodiesOf(same[o], o)) found_.softBodies[later] = earlier;
        }
    }

    bool bodiesMatch(uint32_t earlier, uint32_t later, Pairs& pairs) const
    {
        const Object &then = before_.objects[earlier], &now = after_.objects[later];
        if (then.bodyCount != now.bodyCount) return false;
        for (uint32_t b = 0; b < now.bodyCount; ++b)
            if (!bodyMatches(before_.bodies[then.bodyStart + b], after_.bodies[now.bodyStart + b], pairs)) return false;
        // Joints share the same particles.
        std::map<uint32_t, uint32_t> earlierOf, laterOf;
        return std::ranges::all_of(pairs, [&](const auto& pair) {
            return earlierOf.emplace(pair).first->second == pair.second &&
                   laterOf.emplace(pair.second, pair.first).first->second == pair.first;
        });
    }

    bool bodyMatches(const Body& then, const Body& now, Pairs& pairs) const
    {
        const bool sameRound = then.round.radius == now.round.radius && then.round.halfHeight == now.round.halfHeight;
        if (then.name != now.name || then.linkCount != now.linkCount || !sameRound) return false;
        for (uint32_t k = 0; k < now.linkCount; ++k) {
            const Link &one = before_.links[then.linkStart + k], &other = after_.links[now.linkStart + k];
            if ((one.restOffset - other.restOffset).norm() > SAME * after_.diameter()) return false;
            pairs.emplace_back(other.particle, one.particle);
        }
        return true;
    }

    /// Soft bodies of two objects, one after another, as far as both have them: earlier, later.
    Pairs softBodiesOf(uint32_t earlier, uint32_t later) const
    {
        const auto of = [](const World& world, uint32_t object) {
            std::vector<uint32_t> own;
            for (uint32_t s = 0; s < world.softBodies.size(); ++s)
                if (world.softBodies[s].object == object) own.push_back(s);
            return own;
        };
        const std::vector<uint32_t> then = of(before_, earlier), now = of(after_, later);
        Pairs pairs;
        for (size_t k = 0; k < std::max(then.size(), now.size()); ++k)
            pairs.emplace_back(k < then.size() ? then[k] : NO_INDEX, k < now.size() ? now[k] : NO_INDEX);
        return pairs;
    }

    bool softMatch(uint32_t earlier, uint32_t later, Pairs& pairs) const
    {
        for (const auto& [one, other] : softBodiesOf(earlier, later)) {
            if (one == NO_INDEX || other == NO_INDEX) return false;
            const SoftBody &then = before_.softBodies[one], &now = after_.softBodies[other];
            if (then.particleCount != now.particleCount || then.clusterCount != now.clusterCount) return false;
            for (uint32_t k = 0; k < now.clusterCount; ++k)
                if (!clusterMatches(then, now, k)) return false;
            for (uint32_t k = 0; k < now.particleCount; ++k)
                pairs.emplace_back(now.particleStart + k, then.particleStart + k);
        }
        return true;
    }

    /// Whether a cluster of two soft bodies has the same particles at the same places of the rest pose.
    bool clusterMatches(const SoftBody& then, const SoftBody& now, uint32_t k) const
    {
        const Cluster &one = before_.clusters[then.clusterStart + k], &other = after_.clusters[now.clusterStart + k];
        if (one.linkCount != other.linkCount) return false;
        for (uint32_t l = 0; l < other.linkCount; ++l) {
            const Link &a = before_.clusterLinks[one.linkStart + l], &b = after_.clusterLinks[other.linkStart + l];
            if (a.particle - then.particleStart != b.particle - now.particleStart) return false;
            if ((a.restOffset - b.restOffset).norm() > SAME * after_.diameter()) return false;
        }
        return true;
    }

    using Distances = std::map<std::tuple<DistanceKind, uint32_t, uint32_t>, float>;  // kind, particles: rest length

    /// Per group, the distances between its own particles, which are counted from its first.
    static std::vector<Distances> distancesOf(const World& world)
    {
        std::vector<uint32_t> groups(world.particles.size(), NO_INDEX);
        for (uint32_t g = 0; g < world.looseGroups.size(); ++g)
            for (uint32_t p = world.looseGroups[g].first; p < world.looseGroups[g].end; ++p) groups[p] = g;
        std::vector<Distances> distances(world.looseGroups.size());
        for (const Strand& strand : world.strands)
            for (size_t k = 0; k < strand.restLengths.size(); ++k) {
                const uint32_t a = strand.particles[k], b = strand.particles[k + 1], g = groups[a];
                if (g == NO_INDEX || groups[b] != g) continue;
                const uint32_t first = world.looseGroups[g].first;
                distances[g].emplace(std::tuple{strand.kind, a - first, b - first}, strand.restLengths[k]);
            }
        return distances;
    }

    bool areSame(const Distances& then, const Distances& now) const
    {
        return std::ranges::equal(then, now, [&](const auto& one, const auto& other) {
            return one.first == other.first && std::abs(one.second - other.second) <= SAME * after_.diameter();
        });
    }

    bool isFluid(const World& world, const LooseGroup& group) const { return group.first >= world.solidCount(); }

    void matchGroups()
    {
        const std::vector<uint32_t> same = sameNames(before_.looseGroups, after_.looseGroups);
        const std::vector<Distances> distancesThen = distancesOf(before_), distancesNow = distancesOf(after_);
        for (uint32_t g = 0; g < same.size(); ++g) {
            if (same[g] == NO_INDEX) continue;
            const LooseGroup &then = before_.looseGroups[same[g]], &now = after_.looseGroups[g];
            const bool fluid = isFluid(after_, now);
            if (fluid != isFluid(before_, then)) continue;
            if (fluid) matchFluid(then, now);
            else if (then.end - then.first != now.end - now.first || !areSame(distancesThen[same[g]], distancesNow[g]))
                continue;
            else
                for (uint32_t k = 0; k < now.end - now.first; ++k) found_.particles[now.first + k] = then.first + k;
            groups_.insert(g);
            earlierGroups_.insert(same[g]);
        }
    }

    /// By places: where something solid stands, a fluid has no particles.
    void matchFluid(const LooseGroup& then, const LooseGroup& now)
    {
        const auto place = [](const Particle& p) {
            return std::array{std::bit_cast<uint32_t>(p.position.x()), std::bit_cast<uint32_t>(p.position.y()),
                              std::bit_cast<uint32_t>(p.position.z())};
        };
        std::map<std::array<uint32_t, 3>, uint32_t> places;
        for (uint32_t p = then.first; p < then.end; ++p) places.emplace(place(before_.particles[p]), p);
        for (uint32_t p = now.first; p < now.end; ++p) {
            const auto found = places.find(place(after_.particles[p]));
            if (found != places.end()) found_.particles[p] = found->second;
        }
    }

    /// A strand is the same if all of its particles are.
    void matchStrands()
    {
        using Key = std::pair<DistanceKind, std::vector<uint32_t>>;
        std::map<Key, uint32_t> strands;
        for (uint32_t s = 0; s < before_.strands.size(); ++s)
            strands.emplace(Key{before_.strands[s].kind, before_.strands[s].particles}, s);
        for (const Strand& strand : after_.strands) {
            Key key{strand.kind, {}};
            for (const uint32_t p : strand.particles) key.second.push_back(found_.particles[p]);
            const auto found = strands.find(key);
            found_.strands.push_back(found == strands.end() ? NO_INDEX : found->second);
        }
    }

    void matchEmitters()
    {
        uint32_t earlier = before_.solidCount() + before_.fluidCount - before_.pooledCount();
        uint32_t later = after_.solidCount() + after_.fluidCount - after_.pooledCount();
        for (uint32_t e = 0; e < std::max(before_.emitters.size(), after_.emitters.size()); ++e) {
            const std::string name = "/emitters/" + std::to_string(e);
            const bool was = e < before_.emitters.size(), is = e < after_.emitters.size();
            const bool same = was && is &&
                              before_.materials[before_.emitters[e].material].name ==
                                  after_.materials[after_.emitters[e].material].name;
            if (same) found_.kept.push_back(name);
            if (is && !same) found_.added.push_back(name);
            if (was && !same) found_.gone.push_back(name);
            if (is) found_.emitters.push_back(same ? e : NO_INDEX);
            for (uint32_t k = 0; same && k < std::min(before_.emitters[e].pool, after_.emitters[e].pool); ++k)
                found_.particles[later + k] = earlier + k;
            if (was) earlier += before_.emitters[e].pool;
            if (is) later += after_.emitters[e].pool;
        }
    }

    void matchColliders()
    {
        std::vector<bool> taken(before_.colliders.size());
        const auto isSame = [](const Collider& a, const Collider& b) {
            return a.shape == b.shape && a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs() &&
                   a.halfExtents == b.halfExtents && a.radius == b.radius && a.halfHeight == b.halfHeight;
        };
        for (const Collider& collider : after_.colliders) {
            uint32_t same = 0;
            while (same < taken.size() && (taken[same] || !isSame(before_.colliders[same], collider))) ++same;
            found_.colliders.push_back(same < taken.size() ? same : NO_INDEX);
            if (same < taken.size()) taken[same] = true;
        }
    }

    /// Objects and groups of one name are told once: a rope has both.
    void tellNames()
    {
        std::set<std::string> kept, added, gone;
        const auto tell = [](const auto& things, const std::set<uint32_t>& matched, bool wanted,
                             std::set<std::string>& told, std::vector<std::string>& names) {
            for (uint32_t i = 0; i < things.size(); ++i)
                if (matched.contains(i) == wanted && told.insert(things[i].name).second)
                    names.push_back(things[i].name);
        };
        tell(after_.objects, objects_, true, kept, found_.kept);
        tell(after_.looseGroups, groups_, true, kept, found_.kept);
        tell(after_.objects, objects_, false, added, found_.added);
        tell(after_.looseGroups, groups_, false, added, found_.added);
        tell(before_.objects, earlierObjects_, false, gone, found_.gone);
        tell(before_.looseGroups, earlierGroups_, false, gone, found_.gone);
    }

    const World &before_, &after_;
    Counterparts found_;
    std::set<uint32_t> objects_, earlierObjects_, groups_, earlierGroups_;
};

}  // namespace

Counterparts counterparts(const World& before, const World& after)
{
    return Matcher(before, after).match();
}

}  // namespace knuckle
