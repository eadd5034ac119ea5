#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "sim/solver/buffers.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr uint32_t FIRST_CONTACT_SLOTS = 16;
constexpr float NO_SELF_CONTACT = 1e9f;   // a margin [diameters] that nothing is beyond

gpu::vec4 pack(const Vector3f& v, float w)
{
    return {v.x(), v.y(), v.z(), w};
}

bool isFixed(const World& world, const Particle& particle)
{
    return particle.body != NO_INDEX && world.bodies[particle.body].motion == Motion::Fixed;
}

/// Inverse of the inertia about the centre of shape matching; zero for directions that the body cannot turn about.
Matrix3d inverseInertia(const World& world, const Body& body)
{
    Matrix3d inertia = Matrix3d::Zero();
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
        const Vector3d r = world.links[l].restOffset.cast<double>();
        inertia += world.links[l].mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(inertia);
    const double largest = std::max(eigen.eigenvalues().maxCoeff(), 1e-30);
    Vector3d inverse = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (eigen.eigenvalues()[k] > 1e-6 * largest) inverse[k] = 1.0 / eigen.eigenvalues()[k];
    return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

/// Per link, the largest inverse mass that an impulse on its particle can meet in the body: 1/M plus the largest
/// eigenvalue of [r] I^-1 [r]^T. The largest, so that a Jacobi step never overshoots; the same however the body turns.
std::vector<float> effectiveInverseMasses(const World& world)
{
    std::vector<float> result(world.links.size(), 0.0f);
    for (const Body& body : world.bodies) {
        if (body.motion == Motion::Fixed) continue;
        double mass = 0.0;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) mass += world.links[l].mass;
        const Matrix3d inverse = inverseInertia(world, body);
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const Vector3d r = world.links[l].restOffset.cast<double>();
            Matrix3d cross;
            cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
            const Matrix3d turn = cross * inverse * cross.transpose();
            const double largest = Eigen::SelfAdjointEigenSolver<Matrix3d>(turn).eigenvalues().maxCoeff();
            result[l] = static_cast<float>(1.0 / mass + std::max(largest, 0.0));
        }
    }
    return result;
}

void uploadParticles(SolverBuffers& out, const World& world)
{
    std::vector<gpu::vec4> positions, velocities, rest, masses;
    std::vector<gpu::ParticleInfo> infos;
    uint32_t assemblies = world.assemblyCount;
    for (const Particle& p : world.particles) {
        const bool fixed = isFixed(world, p);
        const Material& material = world.materials[p.material];
        positions.push_back(pack(p.position, 0));
        velocities.push_back(pack(fixed ? Vector3f::Zero() : p.velocity, 0));
        rest.push_back(pack(p.restPosition, p.touchesAssembly ? p.selfMargin : NO_SELF_CONTACT));
        masses.push_back({fixed ? 0.0f : 1.0f / p.mass, 0.0f, material.staticFriction, material.kineticFriction});
        infos.push_back({p.body, p.bodyCount, p.assembly != NO_INDEX ? p.assembly : assemblies++, p.material});
    }
    out.positions = {"positions", std::span<const gpu::vec4>(positions)};
    out.velocities = {"velocities", std::span<const gpu::vec4>(velocities)};
    out.oldMoves = {"oldMoves", positions.size()};
    out.oldVelocities = {"oldVelocities", std::span<const gpu::vec4>(velocities)};
    out.restPositions = {"restPositions", std::span<const gpu::vec4>(rest)};
    out.masses = {"masses", std::span<const gpu::vec4>(masses)};
    out.particleInfo = {"particleInfo", std::span<const gpu::ParticleInfo>(infos)};
    // No contact yet: a stamp that no substep follows.
    const std::vector<gpu::uvec2> state(assemblies, gpu::uvec2{0x7fffffffu, 1u});
    out.assemblyState = {"assemblyState", std::span<const gpu::uvec2>(state)};
}

void uploadBodies(SolverBuffers& out, const World& world)
{
    std::vector<gpu::vec4> centres, rotations;
    std::vector<gpu::BodyInfo> infos;
    std::vector<uint32_t> assemblies;
    for (const Body& body : world.bodies) {
        uint32_t own = 0;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l)
            if (world.particles[world.links[l].particle].bodyCount == 1) ++own;
        centres.push_back(pack(body.position, 0));
        rotations.push_back(pack(body.rotation.vec(), body.rotation.w()));
        infos.push_back({body.linkStart, body.linkCount, own, body.linkCount - own});
        assemblies.push_back(body.assembly);
        out.longestBody = std::max(out.longestBody, body.linkCount);
    }
    out.bodyCentres = {"bodyCentres", std::span<const gpu::vec4>(centres)};
    out.bodyRotations = {"bodyRotations", std::span<const gpu::vec4>(rotations)};
    out.bodyInfo = {"bodyInfo", std::span<const gpu::BodyInfo>(infos)};
    out.bodyAssemblies = {"bodyAssemblies", std::span<const uint32_t>(assemblies)};
    out.bodyStarts = {"bodyStarts", 2 * world.bodies.size()};
    out.bodyTurns = {"bodyTurns", world.bodies.size()};
    out.bodyMoves = {"bodyMoves", world.bodies.size()};
    out.bodyMatrices = {"bodyMatrices", 3 * world.bodies.size()};
}

/// The link array of listing 1, shared particles last in each block, and its inverse.
void uploadLinks(SolverBuffers& out, const World& world)
{
    std::vector<uint32_t> order(world.links.size());
    for (uint32_t l = 0; l < order.size(); ++l) order[l] = l;
    for (const Body& body : world.bodies)
        std::stable_partition(order.begin() + body.linkStart, order.begin() + body.linkStart + body.linkCount,
                              [&](uint32_t l) { return world.particles[world.links[l].particle].bodyCount == 1; });
    const std::vector<float> effective = effectiveInverseMasses(world);
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
    std::vector<gpu::uvec2> ranges, inverse;
    std::vector<uint32_t> shared;
    for (const auto& owned : owners) {
        if (owned.size() > 1) shared.push_back(static_cast<uint32_t>(ranges.size()));
        ranges.push_back({static_cast<uint32_t>(inverse.size()), static_cast<uint32_t>(owned.size())});
        inverse.insert(inverse.end(), owned.begin(), owned.end());
    }
    out.links = {"links", std::span<const gpu::ParticleRigidBodyLink>(links)};
    out.linkMasses = {"linkMasses", std::span<const float>(linkMasses)};
    out.restOffsets = {"restOffsets", std::span<const gpu::vec4>(restOffsets)};
    out.particleLinks = {"particleLinks", std::span<const gpu::uvec2>(ranges)};
    out.linksOfParticle = {"linksOfParticle", std::span<const gpu::uvec2>(inverse)};
    out.sharedParticles = {"sharedParticles", std::span<const uint32_t>(shared)};
    out.parameters.sharedCount = static_cast<uint32_t>(shared.size());
    out.linkOffsets = {"linkOffsets", links.size()};
    out.linkGaps = {"linkGaps", links.size()};
    out.linkTerms = {"linkTerms", 3 * links.size()};
}

void uploadColliders(SolverBuffers& out, const World& world)
{
    std::vector<gpu::GpuCollider> colliders;
    for (const Collider& c : world.colliders) {
        const Vector3f size = c.shape == ColliderShape::Box ? c.halfExtents : Vector3f(c.radius, c.halfHeight, 0);
        colliders.push_back({pack(c.position, static_cast<float>(c.shape)),
                             pack(c.orientation.vec(), c.orientation.w()), pack(size, 0),
                             {c.staticFriction, c.kineticFriction, 0, 0}});
    }
    out.colliders = {"colliders", std::span<const gpu::GpuCollider>(colliders)};
}

void makeGrid(SolverBuffers& out, uint32_t particleCount)
{
    const uint32_t cells = std::bit_ceil(std::max(2u * particleCount, 4096u));
    // A box of cells about as wide as high and deep, wrapped.
    const uint32_t bits = static_cast<uint32_t>(std::countr_zero(cells));
    out.parameters.cellMask = cells - 1;
    out.parameters.cellStrideY = 1u << (bits / 3);
    out.parameters.cellStrideZ = 1u << (2 * bits / 3);
    out.cellCounts = {"cellCounts", cells};
    out.chunkSums = {"chunkSums", cells / CELLS_PER_CHUNK};
    out.cellStarts = {"cellStarts", cells + 3};
    out.cellMembers = {"cellMembers", particleCount};
    out.particleCells = {"particleCells", particleCount};
    out.sortedPositions = {"sortedPositions", 2 * size_t(particleCount)};
    out.sortedIds = {"sortedIds", 2 * size_t(particleCount)};
}

/// The numbers of the impulse solver, and what turns the same kernels into the paper's (docs/physics.md has the figures
/// that decided them).
void setImpulseParameters(gpu::StepParameters& p, const Settings& s)
{
    const bool paper = s.solver == SolverKind::Paper;
    const float h = s.timeStep / static_cast<float>(s.substeps);
    p.correction = paper ? 1.0f : 0.05f;
    p.maxCorrection = paper ? std::numeric_limits<float>::max() : 0.5f * h;
    p.relaxation = 1.8f;
    p.warmStart = 0.95f;
    p.impulseGrowth = 2.0f * s.gravity.norm() * h * h;
    p.jointRelaxation = paper ? 0.0f : 1.3f;
}

void setParameters(SolverBuffers& out, const World& world)
{
    const Settings& s = world.settings;
    const bool paper = s.solver == SolverKind::Paper;
    gpu::StepParameters& p = out.parameters;
    const float h = s.timeStep / static_cast<float>(s.substeps);
    p.gravity = pack(s.gravity, 0);
    p.particleCount = static_cast<uint32_t>(world.particles.size());
    p.bodyCount = static_cast<uint32_t>(world.bodies.size());
    p.linkCount = static_cast<uint32_t>(world.links.size());
    p.colliderCount = static_cast<uint32_t>(world.colliders.size());
    p.diameter = world.diameter();
    p.contactRadius = (1.0f + s.contactMargin) * world.diameter();
    p.inverseCellSize = 1.0f / p.contactRadius;
    p.drift = 0.5f * s.contactMargin * world.diameter();
    p.substepTime = h;
    setImpulseParameters(p, s);
    p.virtualParticles = s.virtualParticles;
    p.freeze = s.freeze * world.particleRadius;
    p.damping = std::exp(-s.linearDamping * h);
    p.maxSpeed = s.maxSpeed;
    p.secondOrder = s.velocityOrder == VelocityOrder::Second ? 1u : 0u;
    p.alwaysFind = paper ? 1u : 0u;
    p.rotationIterations = 3;
}

}  // namespace

void SolverBuffers::resizeContacts(const Gpu& gpu, uint32_t slots)
{
    const uint64_t count = 2ull * (slots + COLLIDER_SLOTS) * parameters.particleCount;
    const auto limit = static_cast<uint64_t>(gpu.limits().storageBlockSize);
    if (count * sizeof(gpu::vec4) > limit || count > static_cast<uint64_t>(gpu.limits().textureBufferSize))
        throw DeviceError(fmt::format("{}: {} particles with {} contacts each need a buffer of {} MiB and the device "
                                      "allows {}; use fewer particles or another --device",
                                      gpu.device().name, parameters.particleCount, slots,
                                      count * sizeof(gpu::vec4) >> 20, limit >> 20));
    parameters.contactSlots = slots;
    candidates = {"candidates", count};
    impulses = {"impulses", count};
    candidateCounts = {"candidateCounts", 2 * size_t(parameters.particleCount)};
    step.upload(std::span<const gpu::StepParameters>(&parameters, 1));
}

SolverBuffers uploadWorld(const Gpu& gpu, const World& world)
{
    SolverBuffers out;
    const auto count = static_cast<uint32_t>(world.particles.size());
    setParameters(out, world);
    out.step = {"step", 1};
    out.counters = {"counters", 1};
    out.dispatches = {"dispatches", 4};
    out.resizeContacts(gpu, FIRST_CONTACT_SLOTS);
    uploadParticles(out, world);
    uploadBodies(out, world);
    uploadLinks(out, world);
    uploadColliders(out, world);
    makeGrid(out, count);
    out.predicted = {"predicted", count};
    out.moved = {"moved", count};
    out.stabilized = {"stabilized", count};
    out.foundPositions = {"foundPositions", count};
    out.step.upload(std::span<const gpu::StepParameters>(&out.parameters, 1));
    return out;
}

BufferTable SolverBuffers::table()
{
    BufferTable t;
    t.add(positions, velocities, oldMoves, oldVelocities, bodyCentres, bodyRotations);
    t.add(particleInfo, masses, restPositions, restOffsets, links, linkMasses, particleLinks, linksOfParticle,
          sharedParticles, bodyInfo, bodyAssemblies, colliders, step);
    t.add(predicted, moved, stabilized, bodyStarts, bodyTurns, bodyMoves, bodyMatrices, linkOffsets, linkGaps,
          linkTerms, assemblyState);
    t.add(foundPositions, particleCells, cellCounts, chunkSums, cellStarts, cellMembers, sortedPositions, sortedIds,
          candidates, impulses, candidateCounts, dispatches);
    t.add("countersBlock", counters, 16);
    // The lists again, for the kernels that read one half while they write the other.
    t.add("oldCandidates", candidates, 4);
    t.add("oldImpulses", impulses, 16);
    return t;
}

}  // namespace knuckle
