#include "sim/solver/layout/layout.h"

#include <algorithm>
#include <numeric>

#include "sim/solver/layout/body_mass.h"

namespace knuckle {

namespace {

/// Per particle: where its body's lattice ends. Bodies with joints are not flat (docs/decisions), and in the paper's
/// solver none are.
std::vector<uint32_t> latticeEndsOf(const World& world)
{
    const bool flat = world.settings.solver == SolverKind::Impulse;
    std::vector<uint32_t> bodies(world.assemblyCount), ends;
    for (const Body& body : world.bodies) ++bodies[body.assembly];
    for (const Particle& p : world.particles)
        ends.push_back(flat && p.bodyCount == 1 && bodies[p.assembly] == 1 ? p.surface.ends : ALL_ENDS);
    return ends;
}

/// Marks the particles of balls and capsules. Among those at the same place along the centre line, only one meets
/// colliders.
void markRounds(const World& world, std::vector<uint32_t>& ends)
{
    const float same = 1e-3f * world.diameter();
    for (const Body& body : world.bodies) {
        if (!body.round.exists()) continue;
        std::vector<float> places;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const float y = world.links[l].restOffset.y() + body.restCentre.y(), half = body.round.halfHeight;
            const float place = std::clamp(y, -half, half);
            const bool first = std::ranges::none_of(places, [&](float p) { return std::abs(p - place) < same; });
            ends[world.links[l].particle] = ALL_ENDS | IN_ROUND | (first ? CARRIES_ROUND : 0u);
            if (first) places.push_back(place);
        }
    }
}

bool isGrid(const Collider& collider)
{
    return collider.shape == ColliderShape::Mesh || collider.shape == ColliderShape::Heightfield;
}

}  // namespace

Layout::Layout(const World& world)
    : solidCount(world.solidCount()), bodyCount(static_cast<uint32_t>(world.bodies.size())),
      linkCount(static_cast<uint32_t>(world.links.size())), worstInverseMasses(knuckle::worstInverseMasses(world)),
      jointTrees(world)
{
    assignAssemblies(world);
    rankParticles(world);
    orderLinks(world);
    listShared();
    findShapes(world);
    firstAnimated.push_back(0);
    for (const Animation& animation : world.animations)
        firstAnimated.push_back(firstAnimated.back() + world.objects[animation.object].bodyCount);
}

uint32_t Layout::heldIndex(uint32_t body) const
{
    const auto at = std::ranges::lower_bound(heldBodies, body);
    return at != heldBodies.end() && *at == body ? static_cast<uint32_t>(at - heldBodies.begin()) : NO_INDEX;
}

void Layout::findShapes(const World& world)
{
    colliderCount = static_cast<uint32_t>(world.colliders.size());
    hasGrids = std::ranges::any_of(world.colliders, isGrid);
    findRegionShapes(world);
    latticeEnds = latticeEndsOf(world);
    hasGrains = std::ranges::any_of(world.particles, [](const Particle& p) { return p.scale != 1.0f; });
    hasFlatFaces = std::ranges::any_of(latticeEnds, [](uint32_t end) { return end != ALL_ENDS; });
    markRounds(world, latticeEnds);
    hasRounds = std::ranges::any_of(world.bodies, [](const Body& body) { return body.round.exists(); });
}

void Layout::findRegionShapes(const World& world)
{
    const auto note = [this](const Region& region) {
        hasBoxRegions |= region.shape == ColliderShape::Box;
        hasRoundRegions |= region.shape == ColliderShape::Sphere || region.shape == ColliderShape::Capsule;
    };
    for (const Collider& collider : world.colliders) note(collider);
    for (const Region& drain : world.drains) note(drain);
    for (const Release& release : world.releases) note(release.region);
}

void Layout::assignAssemblies(const World& world)
{
    assemblyCount = world.assemblyCount;
    for (const Particle& p : world.particles) {
        const bool fluid = assemblies.size() >= solidCount;
        assemblies.push_back(p.assembly != NO_INDEX || fluid ? p.assembly : assemblyCount++);
    }
}

void Layout::rankParticles(const World& world)
{
    ranks.resize(solidCount);
    for (uint32_t i = 0; i < solidCount; ++i) {
        const uint32_t body = world.particles[i].body;
        ranks[i].mover = body != NO_INDEX ? body : bodyCount + looseCount++;
    }
    rankedParticles.resize(solidCount);
    std::iota(rankedParticles.begin(), rankedParticles.end(), 0u);
    std::stable_sort(rankedParticles.begin(), rankedParticles.end(),
                     [&](uint32_t a, uint32_t b) { return ranks[a].mover < ranks[b].mover; });
    moverRanks.resize(moverCount());
    for (uint32_t rank = 0; rank < solidCount; ++rank) {
        gpu::ParticleRank& particle = ranks[rankedParticles[rank]];
        particle.rank = rank;
        gpu::uvec2& mover = moverRanks[particle.mover];
        if (mover.y++ == 0) mover.x = rank;
    }
}

void Layout::orderLinks(const World& world)
{
    linkOrder.resize(linkCount);
    std::iota(linkOrder.begin(), linkOrder.end(), 0u);
    const auto isOwn = [&](uint32_t l) { return world.particles[world.links[l].particle].bodyCount == 1; };
    for (const Body& body : world.bodies) {
        const auto begin = linkOrder.begin() + body.linkStart;
        const auto shared = std::stable_partition(begin, begin + body.linkCount, isOwn);
        ownLinkCounts.push_back(static_cast<uint32_t>(shared - begin));
        const auto index = static_cast<uint32_t>(ownLinkCounts.size() - 1);
        if (mayBeLetGo(body)) heldBodies.push_back(index);
        if (!neverResponds(body)) (ownLinkCounts.back() < body.linkCount ? jointedBodies : freeBodies).push_back(index);
    }
    owners.resize(world.particles.size());
    for (uint32_t l = 0; l < linkCount; ++l) {
        const Link& link = world.links[linkOrder[l]];
        owners[link.particle].push_back({l, link.body});
    }
}

void Layout::listShared()
{
    for (uint32_t i = 0; i < owners.size(); ++i)
        if (owners[i].size() > 1) sharedParticles.push_back(i);
    // Groups particles with equal numbers of bodies, so that the lanes of a vector do the same amount of work.
    std::stable_sort(sharedParticles.begin(), sharedParticles.end(),
                     [&](uint32_t a, uint32_t b) { return owners[a].size() < owners[b].size(); });
}

}  // namespace knuckle
