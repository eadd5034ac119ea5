#include <algorithm>

#include "sim/solver/carry/carrying.h"

namespace knuckle {

namespace {

/// Per element of the earlier stages, its index in the later ones.
std::vector<uint32_t> inverse(const std::vector<uint32_t>& map, size_t count)
{
    std::vector<uint32_t> out(count, NO_INDEX);
    for (uint32_t i = 0; i < map.size(); ++i)
        if (map[i] != NO_INDEX) out[map[i]] = i;
    return out;
}

/// A contact of the last search: particles, or a particle and a collider, and where its impulse is.
struct Contact {
    uint32_t first = 0, second = 0, rank = 0, from = 0;
};

/// Buffers of one kind of contact.
struct List {
    const char *pairs, *impulses, *means;
    uint32_t capacity, count, earlierCapacity;
};

/// The contacts whose both sides are still there, by the rank of the first.
std::vector<Contact> keptContacts(const Carrying& c, const List& list, uint32_t parity,
                                  const std::vector<uint32_t>& first, const std::vector<uint32_t>& second)
{
    const auto pairs = readState<gpu::uvec2>(c.from, list.pairs);
    std::vector<Contact> kept;
    for (uint32_t q = 0; q < std::min(list.count, list.earlierCapacity); ++q) {
        const uint32_t index = parity * list.earlierCapacity + q;
        const uint32_t a = first[pairs[index].x], b = second[pairs[index].y];
        if (a != NO_INDEX && b != NO_INDEX) kept.push_back({a, b, c.after.stages.layout.ranks[a].rank, index});
    }
    std::ranges::stable_sort(kept, {}, &Contact::rank);
    kept.resize(std::min<size_t>(kept.size(), list.capacity));
    return kept;
}

/// Writes the first half of a list, which the next search reads as the old one.
void write(const Carrying& c, const List& list, const std::vector<Contact>& contacts)
{
    const auto oldImpulses = readState<gpu::vec4>(c.from, list.impulses);
    const auto oldMeans = readState<float>(c.from, list.means);
    auto pairs = readState<gpu::uvec2>(c.to, list.pairs);
    auto impulses = readState<gpu::vec4>(c.to, list.impulses);
    auto means = readState<float>(c.to, list.means);
    const auto scale = static_cast<float>(c.substepRatio() * c.substepRatio());
    for (size_t q = 0; q < contacts.size(); ++q) {
        const gpu::vec4& p = oldImpulses[contacts[q].from];
        pairs[q] = {contacts[q].first, contacts[q].second};
        impulses[q] = {scale * p.x, scale * p.y, scale * p.z, scale * p.w};
        means[q] = scale * oldMeans[contacts[q].from];
    }
    writeState(c.to, list.pairs, pairs);
    writeState(c.to, list.impulses, impulses);
    writeState(c.to, list.means, means);
}

}  // namespace

void carryContacts(const Carrying& c)
{
    const auto counters = readState<gpu::Counters>(c.from, "countersBlock").at(0);
    const gpu::StepParameters &then = c.from.parameters, &now = c.to.parameters;
    if (now.particleCount == 0 || then.particleCount == 0) return;
    const std::vector<uint32_t> particles = inverse(c.maps.of(Per::Particle), c.before.world.particles.size());
    const std::vector<uint32_t> colliders = inverse(c.same.colliders, c.before.world.colliders.size());
    const List pairs{"pairs", "pairImpulses", "pairMeans", now.pairCapacity, counters.pairCount, then.pairCapacity};
    const List walls{"colliderPairs",          "colliderImpulses",         "colliderMeans",
                     now.colliderPairCapacity, counters.colliderPairCount, then.colliderPairCapacity};
    const std::vector<Contact> kept = keptContacts(c, pairs, counters.listParity, particles, particles);
    const std::vector<Contact> keptWalls = keptContacts(c, walls, counters.listParity, particles, colliders);
    write(c, pairs, kept);
    write(c, walls, keptWalls);

    // As contact_lists.glsl has them: by first particle, by second one (none), with colliders.
    auto starts = readState<uint32_t>(c.to, "listStarts");
    const size_t n = now.particleCount;
    std::fill(starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(3 * n + 1), 0u);
    for (const Contact& contact : kept) ++starts[contact.rank + 1];
    for (const Contact& contact : keptWalls) ++starts[2 * n + contact.rank + 1];
    for (size_t k = 1; k <= 3 * n; ++k) starts[k] += starts[k - 1];
    writeState(c.to, "listStarts", starts);
}

}  // namespace knuckle
