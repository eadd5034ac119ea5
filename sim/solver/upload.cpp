#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "sim/solver/body/body_mass.h"
#include "sim/solver/buffers.h"
#include "sim/solver/pack.h"
#include "sim/solver/upload_colliders.h"
#include "sim/solver/fluid/upload_fluid.h"
#include "sim/solver/body/upload_movers.h"
#include "sim/solver/paper/upload_paper.h"
#include "sim/solver/fluid/upload_pool.h"
#include "sim/solver/soft/upload_soft.h"
#include "sim/solver/rope/upload_distances.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

// For how long what freezes has to be calm [s].
constexpr float FREEZE_SECONDS = 1.0f;
constexpr uint32_t FIRST_CONTACT_SLOTS = 8;
constexpr uint64_t MOST_PARTICLES = 1u << 23;   // contacts have 23 bits for a mover
// How far particles may be from each other where one touches the other's box [diameters]: in the middle of four of a
// face root 1.5, less what it may sink in before it is found; root 2 would find all neighbours across two faces.
constexpr float FLAT_TOUCH = 1.2f;
constexpr float NO_SELF_CONTACT = 1e9f;   // a margin [diameters] that nothing is beyond

bool isFixed(const World& world, const Particle& particle)
{
    return particle.body != NO_INDEX && world.bodies[particle.body].motion == Motion::Fixed;
}

/// Per particle: where its body's lattice ends. Bodies with joints keep their bumps (docs/physics.md), and so do all in
/// the paper's solver.
std::vector<uint32_t> latticeEnds(const World& world)
{
    const bool flat = world.settings.solver == SolverKind::Impulse;
    std::vector<uint32_t> bodies(world.assemblyCount), ends;
    for (const Body& body : world.bodies) ++bodies[body.assembly];
    for (const Particle& p : world.particles)
        ends.push_back(flat && p.bodyCount == 1 && bodies[p.assembly] == 1 ? p.surface.ends : ALL_ENDS);
    return ends;
}

void uploadParticles(SolverBuffers& out, const World& world)
{
    std::vector<gpu::vec4> positions, velocities, rest, masses, surfaces;
    std::vector<gpu::ParticleInfo> infos;
    uint32_t assemblies = world.assemblyCount;
    const size_t firstPooled = world.particles.size() - world.pooledCount();
    for (const Particle& p : world.particles) {
        const bool fixed = isFixed(world, p);
        const Material& material = world.materials[p.material];
        positions.push_back(pack(p.position, positions.size() >= firstPooled ? 1.0f : 0.0f));
        velocities.push_back(pack(fixed ? Vector3f::Zero() : p.velocity, 0));
        surfaces.push_back(p.bodyCount == 1 ? pack(p.surface.outward, p.surface.distance) : gpu::vec4{});
        rest.push_back(pack(p.restPosition, p.touchesAssembly ? p.selfMargin : NO_SELF_CONTACT));
        const bool fluid = material.fluid;
        infos.push_back({fluid ? IN_FLUID : p.body, p.bodyCount,
                         p.assembly != NO_INDEX || fluid ? p.assembly : assemblies++, p.material});
        masses.push_back({fixed ? 0.0f : 1.0f / p.mass, material.restitution, material.staticFriction,
                          material.kineticFriction});
    }
    const size_t count = positions.size();
    out.positions = {"positions", std::span<const gpu::vec4>(positions)};
    out.velocities = {"velocities", std::span<const gpu::vec4>(velocities)};
    out.restPositions = {"restPositions", std::span<const gpu::vec4>(rest)};
    out.masses = {"masses", std::span<const gpu::vec4>(masses)};
    out.particleSurfaces = {"particleSurfaces", std::span<const gpu::vec4>(surfaces)};
    out.particleInfo = {"particleInfo", std::span<const gpu::ParticleInfo>(infos)};
    out.searchPositions = {"searchPositions", count};
    // No contact yet: a stamp that no substep follows.
    const std::vector<gpu::uvec2> state(assemblies, gpu::uvec2{0x7fffffffu, 1u});
    out.assemblyState = {"assemblyState", std::span<const gpu::uvec2>(state)};
    out.parameters.assemblyCount = assemblies;
}

void uploadBodies(SolverBuffers& out, const World& world)
{
    std::vector<gpu::BodyInfo> infos;
    for (const Body& body : world.bodies) {
        uint32_t own = 0;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l)
            if (world.particles[world.links[l].particle].bodyCount == 1) ++own;
        infos.push_back({body.linkStart, body.linkCount, own, body.linkCount - own});
    }
    out.bodyInfo = {"bodyInfo", std::span<const gpu::BodyInfo>(infos)};
}

/// The link array of listing 1, shared particles last in each block, and its inverse.
void uploadLinks(SolverBuffers& out, const World& world)
{
    std::vector<uint32_t> order(world.links.size());
    for (uint32_t l = 0; l < order.size(); ++l) order[l] = l;
    for (const Body& body : world.bodies)
        std::stable_partition(order.begin() + body.linkStart, order.begin() + body.linkStart + body.linkCount,
                              [&](uint32_t l) { return world.particles[world.links[l].particle].bodyCount == 1; });
    const std::vector<float> effective = worstInverseMasses(world);
    std::vector<gpu::ParticleRigidBodyLink> links;
    std::vector<float> linkMasses;
    std::vector<gpu::vec4> restOffsets(world.particles.size());
    std::vector<std::vector<gpu::uvec2>> owners(world.particles.size());
    for (uint32_t l = 0; l < order.size(); ++l) {
        const Link& link = world.links[order[l]];
        const Body& body = world.bodies[link.body];
        const Vector3f& r = link.restOffset;
        links.push_back({link.particle, link.body, r.x(), r.y(), r.z(), body.linkStart, body.linkCount, link.mass});
        linkMasses.push_back(effective[order[l]]);
        if (world.particles[link.particle].body == link.body) restOffsets[link.particle] = pack(r, effective[order[l]]);
        owners[link.particle].push_back({l, link.body});
    }
    for (uint32_t i = 0; i < world.particles.size(); ++i)
        if (world.particles[i].body == NO_INDEX) restOffsets[i].w = 1.0f / world.particles[i].mass;
    std::vector<gpu::uvec2> ranges, inverse;
    std::vector<uint32_t> shared;
    for (const auto& owned : owners) {
        if (owned.size() > 1) shared.push_back(static_cast<uint32_t>(ranges.size()));
        ranges.push_back({static_cast<uint32_t>(inverse.size()), static_cast<uint32_t>(owned.size())});
        inverse.insert(inverse.end(), owned.begin(), owned.end());
    }
    // Those of as many bodies together: the threads of a vector then do as much.
    std::stable_sort(shared.begin(), shared.end(), [&](uint32_t a, uint32_t b) { return ranges[a].y < ranges[b].y; });
    appendClusterLinks(links, world);
    out.links = {"links", std::span<const gpu::ParticleRigidBodyLink>(links)};
    out.linkMasses = {"linkMasses", std::span<const float>(linkMasses)};
    out.restOffsets = {"restOffsets", std::span<const gpu::vec4>(restOffsets)};
    out.particleLinks = {"particleLinks", std::span<const gpu::uvec2>(ranges)};
    out.linksOfParticle = {"linksOfParticle", std::span<const gpu::uvec2>(inverse)};
    out.sharedParticles = {"sharedParticles", std::span<const uint32_t>(shared)};
    out.parameters.sharedCount = static_cast<uint32_t>(shared.size());
    std::vector<gpu::uvec4> sharedOwners;
    for (uint32_t particle : shared) {
        if (owners[particle].size() != 2) break;
        const gpu::uvec2 a = owners[particle][0], b = owners[particle][1];
        sharedOwners.push_back({a.x, a.y, b.x, b.y});
    }
    out.parameters.sharedByTwo = static_cast<uint32_t>(sharedOwners.size());
    out.sharedOwners = {"sharedOwners", std::span<const gpu::uvec4>(sharedOwners)};
    out.linkImpulses = {"linkImpulses", world.links.size()};
    makePaper(out, world, links, linkMasses);
}

void makeGrid(SolverBuffers& out, uint32_t particleCount)
{
    const uint32_t cells = std::bit_ceil(std::max(particleCount, 4096u));
    // A box of cells about as wide as high and deep, wrapped.
    const uint32_t bits = static_cast<uint32_t>(std::countr_zero(cells));
    out.parameters.cellMask = cells - 1;
    out.parameters.cellStrideY = 1u << (bits / 3);
    out.parameters.cellStrideZ = 1u << (2 * bits / 3);
    out.cellCounts = {"cellCounts", cells};
    out.cellSums = {"cellSums", cells / SCAN_CHUNK};
    out.cellStarts = {"cellStarts", cells + WRAPPED_CELLS + 1};
    out.cellMembers = {"cellMembers", particleCount};
    out.fastParticles = {"fastParticles", particleCount};
    out.particleCells = {"particleCells", particleCount};
    out.sortedPositions = {"sortedPositions", 2 * size_t(particleCount)};
    out.sortedInfos = {"sortedInfos", 2 * size_t(particleCount)};
}

/// The numbers of the impulse solver (docs/physics.md has the figures that decided them).
void setImpulseParameters(gpu::StepParameters& p, const Settings& s)
{
    p.correction = 0.06f;
    p.maxCorrection = 0.25f * p.substepTime;
    // What a substep keeps of an impulse, of what it differs by from its mean, and of the mean.
    const float iterations = static_cast<float>(s.iterations);
    p.warmStart = std::pow(0.985f, 1.0f / iterations);
    p.calming = 1.0f - std::pow(0.95f, 1.0f / iterations);
    p.meanRate = 1.0f - std::pow(0.9975f, 1.0f / iterations);
    p.jointRelaxation = 1.8f;
    p.vorticity = s.vorticity * s.timeStep;
    // Twice what gravity gives in a substep: what rests does not bounce.
    p.restitutionThreshold = std::max(2.0f * s.gravity.norm() * p.substepTime, 0.02f);
}

/// How far contacts are looked for, and for how long they stay good. Neighbours rarely use up their margins both and
/// against each other, so each may drift by more than half of it. The paper's particles may drift by a quarter: the
/// iterations move them further by as much.
void setSearchParameters(gpu::StepParameters& p, const Settings& s, std::span<const uint32_t> ends)
{
    const bool flat = std::ranges::any_of(ends, [](uint32_t end) { return end != ALL_ENDS; });
    p.contactRadius = ((flat ? FLAT_TOUCH : 1.0f) + s.contactMargin) * p.diameter;
    p.inverseCellSize = 1.0f / p.contactRadius;
    p.drift = (s.solver == SolverKind::Paper ? 0.25f : 1.0f) * s.contactMargin * p.diameter;
    p.lookAhead = 0.5f * static_cast<float>(s.substeps);
    p.horizon = 2.0f * static_cast<float>(s.substeps);
    p.farReach = 0.5f * p.contactRadius;
    p.fastLimit = p.particleCount / 8;
}

void setParameters(SolverBuffers& out, const World& world, std::span<const uint32_t> ends)
{
    const Settings& s = world.settings;
    gpu::StepParameters& p = out.parameters;
    p.gravity = pack(s.gravity, 0);
    p.particleCount = world.solidCount();
    p.bodyCount = static_cast<uint32_t>(world.bodies.size());
    p.linkCount = static_cast<uint32_t>(world.links.size());
    p.moverCount = p.bodyCount;
    for (uint32_t i = 0; i < p.particleCount; ++i)
        if (world.particles[i].body == NO_INDEX) ++p.moverCount;
    p.colliderCount = static_cast<uint32_t>(world.colliders.size());
    p.diameter = world.diameter();
    p.substepTime = s.timeStep / static_cast<float>(s.substeps);
    p.virtualParticles = s.virtualParticles;
    p.massScaling = s.massScaling;
    p.sleepSpeed = s.sleepSpeed;
    // No two places within half as far from a third are further apart.
    p.freeze = 0.5f * s.freeze * world.particleRadius;
    p.calmSteps = CALM_STEPS;
    const auto freezeSteps = static_cast<uint32_t>(std::ceil(FREEZE_SECONDS / s.timeStep));
    if (s.freeze > 0.0f) p.calmSteps = std::max(CALM_STEPS, freezeSteps);
    p.damping = std::exp(-s.linearDamping * p.substepTime);
    p.maxSpeed = s.maxSpeed;
    p.secondOrder = s.velocityOrder == VelocityOrder::Second ? 1u : 0u;
    p.rotationIterations = 3;
    setSearchParameters(p, s, ends);
    setImpulseParameters(p, s);
    if (s.solver == SolverKind::Paper) setPaperParameters(p, world);
}

}  // namespace

void SolverBuffers::resizeContacts(const Gpu& gpu)
{
    const size_t count = parameters.particleCount;
    const uint64_t largest = std::max<uint64_t>(parameters.contactSlots * count, 2ull * parameters.pairCapacity);
    const auto limit = static_cast<uint64_t>(gpu.limits().storageBlockSize);
    if (largest * sizeof(gpu::vec4) > limit || largest > static_cast<uint64_t>(gpu.limits().textureBufferSize) ||
        count > MOST_PARTICLES)
        throw DeviceError(fmt::format("{}: {} particles with {} contacts need a buffer of {} MiB and the device "
                                      "allows {}; use fewer particles or another --device",
                                      gpu.device().name, count, parameters.pairCapacity,
                                      largest * sizeof(gpu::vec4) >> 20, limit >> 20));
    const size_t pairCount = parameters.pairCapacity, colliderCount = parameters.colliderPairCapacity;
    firstLists = {"firstLists", parameters.contactSlots * count};
    colliderLists = {"colliderLists", COLLIDER_SLOTS * count};
    listCounts = {"listCounts", 3 * count};
    listSums = {"listSums", 3 * count / SCAN_CHUNK + 1};
    listStarts = {"listStarts", 2 * (3 * count + 1)};
    pairs = {"pairs", 2 * pairCount};
    pairSides = {"pairSides", pairCount};
    pairArms = {"pairArms", 2 * pairCount};
    pairImpulses = {"pairImpulses", 2 * pairCount};
    pairMeans = {"pairMeans", 2 * pairCount};
    pairArrivals = {"pairArrivals", parameters.contactSlots * count};
    pairReferences = {"pairReferences", parameters.contactSlots * count};
    colliderPairs = {"colliderPairs", 2 * colliderCount};
    colliderSides = {"colliderSides", colliderCount};
    colliderArms = {"colliderArms", colliderCount};
    colliderImpulses = {"colliderImpulses", 2 * colliderCount};
    colliderMeans = {"colliderMeans", 2 * colliderCount};
    pairRestitutions = {"pairRestitutions", hasRestitution ? 2 * pairCount : 0};
    colliderRestitutions = {"colliderRestitutions", hasRestitution ? 2 * colliderCount : 0};
    step.upload(std::span<const gpu::StepParameters>(&parameters, 1));
}

SolverBuffers uploadWorld(const Gpu& gpu, const World& world)
{
    SolverBuffers out;
    const uint32_t count = world.solidCount();
    const std::vector<uint32_t> ends = latticeEnds(world);
    setParameters(out, world, ends);
    setFluidParameters(out.parameters, world);
    out.step = {"step", 1};
    out.counters = {"counters", 1};
    out.parameters.contactSlots = FIRST_CONTACT_SLOTS;
    out.parameters.pairCapacity = out.parameters.colliderPairCapacity = std::max(2 * count, 4096u);
    for (const Material& material : world.materials) out.hasRestitution |= material.restitution > 0.0f;
    out.resizeContacts(gpu);
    out.latticeEnds = {"latticeEnds", std::span<const uint32_t>(ends)};
    uploadParticles(out, world);
    uploadBodies(out, world);
    uploadMovers(out, world);
    uploadSleep(out);
    uploadDistances(out, world);
    uploadLinks(out, world);
    uploadColliders(gpu, out, world);
    makeGrid(out, count);
    makeFluid(out, world, gpu);
    makePool(out, world);
    uploadSoftBodies(out, world);
    out.step.upload(std::span<const gpu::StepParameters>(&out.parameters, 1));
    return out;
}

BufferTable SolverBuffers::table()
{
    BufferTable t;
    t.add(positions, velocities, particleInfo, particleRanks, rankedParticles, masses, restPositions, restOffsets,
          links, linkMasses, particleLinks, linksOfParticle, bodyInfo, bodyMoments, bodyInertias, moverInfo, moverStates,
          sharedParticles, sharedOwners, particleSurfaces, latticeEnds, colliders, gridValues, step);
    t.add(clusterInfo, clusterMoments, softMatter, softParticles, softLinks, clusterRotations, clusterRests,
          clusterPulls, softImpulses);
    t.add(moverCentres, moverRotations, moverMoves, moverRotationDeltas, moverVelocities, oldMoverVelocities, oldMoverMoves,
          moverPredictions, moverImpulses, moverChanges, particleImpulses, linkImpulses, assemblyState, assemblyCalm,
          assemblyNext, islandsWoken);
    t.add(oldMoves, oldVelocities, predicted, moved, bodyStarts, bodyMatrices, bodyActing, linkGains, linkPulls,
          linkTerms, reductionLinks);
    t.add(distanceRows, distanceNodes, distanceLinks, distanceStates, distanceFactors);
    t.add(searchPositions, searchCentres, searchRotations, moverReaches, fastParticles, moverColliders, particleCells,
          cellCounts, cellSums, cellStarts, cellMembers, sortedPositions, sortedInfos);
    t.add(firstLists, colliderLists, listCounts, listSums, listStarts, pairs, pairSides, pairArms, pairImpulses,
          pairMeans, pairArrivals, pairReferences, colliderPairs, colliderSides, colliderArms, colliderImpulses,
          colliderMeans, dispatches);
    t.add(calmCentres, calmRotations);
    addFluid(t, fluid);
    addPool(t, pool);
    t.add(pairRestitutions, colliderRestitutions, moverRestitutionSplits);
    t.add("countersBlock", counters, 16);
    return t;
}

}  // namespace knuckle
