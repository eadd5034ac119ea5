#include <algorithm>
#include <stdexcept>

#include "sim/base/disjoint_sets.h"
#include "sim/world/builder/builder.h"
#include "sim/world/builder/parts/clusters.h"
#include "sim/world/builder/parts/substeps.h"

namespace knuckle {

namespace {

/// Weight of a body when the masses of shared particles are split. The cross of a universal joint is light; a larger
/// part of those masses makes it more like its neighbours, so that the impulses between them converge sooner.
float shareWeight(const Body& body)
{
    return body.isCross ? 6.0f : 1.0f;
}

/// Removes round shapes of bodies with joints, which keep their particles' shape: limbs overlap around joints.
void dropJointedRounds(World& world)
{
    std::vector<uint32_t> bodies(world.assemblyCount);
    for (const Body& body : world.bodies) ++bodies[body.assembly];
    for (Body& body : world.bodies)
        if (bodies[body.assembly] > 1) body.round = {};
}

}  // namespace

void WorldBuilder::assignAssemblies()
{
    // Bodies that share a particle or are geared belong to one assembly; until it is numbered, the smallest body index
    // names it.
    DisjointSets sets(world_.bodies.size());
    owners_.resize(world_.particles.size());
    for (uint32_t b = 0; b < bodyParticles_.size(); ++b)
        for (uint32_t p : bodyParticles_[b]) {
            Particle& particle = world_.particles[p];
            if (particle.body == NO_INDEX) particle.body = b;
            ++particle.bodyCount;
            owners_[p].push_back(b);
            sets.unite(particle.body, b);
        }
    for (const GearDraft& gear : gears_) sets.unite(gear.first.child, gear.second.child);
    for (uint32_t b = 0; b < sets.size(); ++b) {
        const uint32_t top = sets.find(b);
        world_.bodies[b].assembly = top == b ? world_.assemblyCount++ : world_.bodies[top].assembly;
    }
    for (Particle& particle : world_.particles)
        if (particle.body != NO_INDEX) particle.assembly = world_.bodies[particle.body].assembly;
}

float WorldBuilder::massFraction(uint32_t particle, uint32_t body) const
{
    float all = 0.0f;
    for (uint32_t owner : owners_[particle]) all += shareWeight(world_.bodies[owner]);
    return shareWeight(world_.bodies[body]) / all;
}

void WorldBuilder::makeBodyLinks(uint32_t bodyIndex)
{
    Body& body = world_.bodies[bodyIndex];
    body.linkStart = static_cast<uint32_t>(world_.links.size());
    body.linkCount = static_cast<uint32_t>(bodyParticles_[bodyIndex].size());
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double mass = 0.0;
    for (uint32_t p : bodyParticles_[bodyIndex]) {
        const Particle& particle = world_.particles[p];
        const auto foreign = foreignPlaces_.find({bodyIndex, p});
        const Vector3f& place = foreign != foreignPlaces_.end() ? foreign->second : particle.restPosition;
        Link link{p, bodyIndex, place, particle.mass};
        if (world_.settings.splitSharedMass) link.mass *= massFraction(p, bodyIndex);
        mass += link.mass;
        centre += link.mass * place.cast<double>();
        world_.links.push_back(link);
    }
    centre /= mass;
    body.mass = static_cast<float>(mass);
    body.restCentre = centre.cast<float>();
    for (uint32_t i = 0; i < body.linkCount; ++i) {
        Vector3f& offset = world_.links[body.linkStart + i].restOffset;
        offset = (offset.cast<double>() - centre).cast<float>();
    }
    body.position += body.rotation * body.restCentre;
}

void WorldBuilder::restWherePlaced()
{
    std::vector<bool> joined(world_.assemblyCount, false);
    for (const auto& [key, place] : foreignPlaces_) joined[world_.bodies[key.first].assembly] = true;
    for (Particle& particle : world_.particles)
        if (particle.assembly != NO_INDEX && joined[particle.assembly]) particle.restPosition = particle.position;
}

void WorldBuilder::weighRounds()
{
    for (uint32_t b = 0; b < world_.bodies.size(); ++b) {
        const Body& body = world_.bodies[b];
        if (!body.round.exists()) continue;
        const float all = world_.materials[body.material].density * body.round.volume();
        for (uint32_t p : bodyParticles_[b])
            world_.particles[p].mass = all / static_cast<float>(bodyParticles_[b].size());
    }
}

World WorldBuilder::build()
{
    if (objectOpen_) throw std::logic_error("build(): the last object is still open");
    // A particle of any fixed body is fixed: that body must come first in its list of owners.
    for (uint32_t b = 0; b < bodyParticles_.size(); ++b)
        if (world_.bodies[b].motion == Motion::Fixed)
            for (uint32_t p : bodyParticles_[b]) world_.particles[p].body = b;
    assignAssemblies();
    if (fluid_.empty() && world_.emitters.empty()) weighRounds();
    for (uint32_t b = 0; b < world_.bodies.size(); ++b) makeBodyLinks(b);
    recordJoints();
    restWherePlaced();
    dropJointedRounds(world_);
    makeSoftLinks(world_);
    joinStrandAssemblies(world_);
    placeFluid();
    if (choosesSubsteps_) world_.settings.substeps = std::max(world_.settings.substeps, clothSubsteps(world_));
    validate(world_);
    return std::move(world_);
}

}  // namespace knuckle
