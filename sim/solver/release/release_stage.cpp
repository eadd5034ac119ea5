#include "sim/solver/release/release_stage.h"

#include <algorithm>

#include "sim/solver/restitution/restitution_stage.h"

namespace knuckle {

namespace {

bool hasCause(const World& world, ReleaseCause cause)
{
    return std::ranges::any_of(world.releases, [&](const Release& release) { return release.cause == cause; });
}

/// Adds those bodies of a release that belong to a puppet and go limp with it, as indices among all animated bodies.
void addLimps(std::vector<uint32_t>& limps, const StageSetup& setup, const Release& release)
{
    if (release.driven) return;
    for (const Puppet& puppet : setup.world.puppets) {
        const Object& object = objectOf(setup.world, puppet);
        for (const uint32_t body : release.bodies)
            if (object.has(body))
                limps.push_back(setup.layout.firstAnimated[puppet.animation] + body - object.bodyStart);
    }
}

}  // namespace

bool ReleaseStage::isNeeded(const World& world)
{
    return world.settings.solver == SolverKind::Impulse && std::ranges::any_of(world.bodies, mayBeLetGo);
}

ReleaseStage::ReleaseStage(const StageSetup& setup)
    : parameters_(setup.parameters), byImpulse_(hasCause(setup.world, ReleaseCause::Impulse)),
      byTouch_(hasCause(setup.world, ReleaseCause::Touch)), byRegion_(hasCause(setup.world, ReleaseCause::Region)),
      impulse_(*this, "release/release_impulse", definesOf({{"BOUNCES", RestitutionStage::isNeeded(setup.world)}}),
               byImpulse_)
{
}

void ReleaseStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    const auto firstRegion = static_cast<uint32_t>(world.colliders.size() + world.drains.size());
    std::vector<gpu::Release> all;
    std::vector<uint32_t> entries, limps;
    for (const Release& release : world.releases) {
        const Object& object = world.objects[world.bodies[release.bodies[0]].object];
        const auto first = static_cast<uint32_t>(entries.size()), index = static_cast<uint32_t>(all.size());
        for (const uint32_t body : release.bodies)
            if (const uint32_t entry = setup.layout.heldIndex(body); entry != NO_INDEX) entries.push_back(entry);
        const auto firstLimp = static_cast<uint32_t>(limps.size());
        addLimps(limps, setup, release);
        all.push_back({first, static_cast<uint32_t>(entries.size()), object.bodyStart, object.bodyEnd(),
                       release.firstParticle, release.endParticle, release.impulse, firstRegion + index, firstLimp,
                       static_cast<uint32_t>(limps.size()), 0, 0});
    }
    std::vector<gpu::uvec2> watches;
    const auto addWatches = [&](ReleaseCause cause) {
        const size_t before = watches.size();
        for (uint32_t r = 0; r < all.size(); ++r)
            for (const uint32_t body : world.releases[r].bodies)
                if (world.releases[r].cause == cause) watches.push_back({r, body});
        return static_cast<uint32_t>(watches.size() - before);
    };
    setup.parameters.impulseWatchCount = addWatches(ReleaseCause::Impulse);
    setup.parameters.touchWatchCount = addWatches(ReleaseCause::Touch);
    setup.parameters.regionWatchCount = addWatches(ReleaseCause::Region);
    releases = {"releases", std::span<const gpu::Release>(all)};
    releaseEntries = {"releaseEntries", std::span<const uint32_t>(entries)};
    releaseLimps = {"releaseLimps", std::span<const uint32_t>(limps)};
    releaseWatches = {"releaseWatches", std::span<const gpu::uvec2>(watches)};
    releaseImpulses = {"releaseImpulses", size_t{setup.parameters.impulseWatchCount} * world.settings.substeps};
    releaseImpulses.clear();
    releaseNotes = {"releaseNotes", 3 * setup.layout.heldBodies.size()};
}

void ReleaseStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, releases, releaseEntries, releaseLimps, releaseWatches);
    table.add(Lifetime::State, releaseImpulses, releaseNotes);
}

void ReleaseStage::watch(Recorder& recorder) const
{
    recorder.perElement(impulse_, parameters_.impulseWatchCount);
    recorder.perElement(touch_, parameters_.touchWatchCount);
    recorder.perElement(region_, parameters_.regionWatchCount);
}

void ReleaseStage::noteBefore(Recorder& recorder) const
{
    if (notes_) recorder.perElement(before_, parameters_.releaseCount);
}

void ReleaseStage::noteAfter(Recorder& recorder) const
{
    if (notes_) recorder.perElement(after_, parameters_.releaseCount);
}

std::vector<LetGo> ReleaseStage::letGo(const std::vector<gpu::uvec2>& bodyReleases, uint32_t substep) const
{
    const std::vector<gpu::vec4> notes = releaseNotes.download();
    const auto vector = [&](size_t index) { return Vector3f(notes[index].x, notes[index].y, notes[index].z); };
    std::vector<LetGo> gone;
    for (size_t k = 0; k < bodyReleases.size(); ++k) {
        const auto [body, since] = bodyReleases[k];
        if (since > 0 && since < substep)
            gone.push_back({body, since, vector(3 * k), vector(3 * k + 1), vector(3 * k + 2), notes[3 * k + 2].w});
    }
    return gone;
}

}  // namespace knuckle
