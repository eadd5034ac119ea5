#include "sim/solver/body/upload_movers.h"

#include <Eigen/QR>
#include <algorithm>
#include <numeric>

#include "sim/solver/body/body_mass.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Arrays per mover, bodies first.
struct Movers {
    std::vector<gpu::MoverInfo> infos;
    std::vector<uint32_t> states;                            ///< MOVER_*
    std::vector<gpu::vec4> centres, rotations, velocities;   ///< The last: fields.
    std::vector<gpu::vec4> moments, inertias;                ///< Of bodies.
};

/// The particles of a body move as one: the linear field nearest to their velocities, by least squares.
void addVelocityField(std::vector<gpu::vec4>& out, const World& world, const Body& body, const BodyMass& mass)
{
    Vector3d momentum = Vector3d::Zero();
    Matrix3d cross = Matrix3d::Zero();
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
        const Vector3d v = world.links[l].mass * world.particles[world.links[l].particle].velocity.cast<double>();
        momentum += v;
        cross += v * world.links[l].restOffset.cast<double>().transpose();
    }
    const bool fixed = body.motion == Motion::Fixed;
    out.push_back(pack(fixed ? Vector3f::Zero() : Vector3f((momentum / mass.mass).cast<float>()), 0));
    const Matrix3d f = mass.moments.completeOrthogonalDecomposition().solve(cross.transpose()).transpose();
    for (int column = 0; column < 3; ++column)
        out.push_back(pack(fixed ? Vector3f::Zero() : Vector3f(f.col(column).cast<float>()), 0));
}

void addMass(Movers& out, const BodyMass& mass)
{
    for (int column = 0; column < 3; ++column)
        out.moments.push_back(pack(mass.moments.col(column).cast<float>(), static_cast<float>(mass.radius)));
    const Eigen::Matrix3f inverse = mass.inverseInertia.cast<float>();
    out.inertias.push_back(pack(inverse.diagonal(), static_cast<float>(1.0 / mass.mass)));
    out.inertias.push_back({inverse(0, 1), inverse(0, 2), inverse(1, 2), 0});
}

Movers makeMovers(const World& world, uint32_t assemblies)
{
    Movers movers;
    for (const Body& body : world.bodies) {
        const BodyMass mass = bodyMass(world, body);
        const bool fixed = body.motion == Motion::Fixed;
        movers.infos.push_back({0, 0, body.assembly, fixed ? 0.0f : static_cast<float>(1.0 / mass.mass)});
        movers.states.push_back(fixed ? MOVER_FIXED : MOVER_DYNAMIC);
        addMass(movers, mass);
        movers.centres.push_back(pack(body.position, 0));
        movers.rotations.push_back(pack(body.rotation.vec(), body.rotation.w()));
        addVelocityField(movers.velocities, world, body, mass);
    }
    for (uint32_t i = 0; i < world.solidCount(); ++i) {
        const Particle& p = world.particles[i];
        if (p.body != NO_INDEX) continue;
        movers.infos.push_back({0, 0, p.assembly != NO_INDEX ? p.assembly : assemblies++, 1.0f / p.mass});
        movers.states.push_back(MOVER_DYNAMIC);
        movers.centres.push_back(pack(p.position, 0));
        movers.rotations.push_back({0, 0, 0, 1});
        movers.velocities.push_back(pack(p.velocity, 0));
    }
    return movers;
}

/// Ranks the particles by mover, then by id, and notes each mover's range.
void rankParticles(SolverBuffers& out, const World& world, Movers& movers)
{
    std::vector<gpu::uvec2> places(world.solidCount());
    auto loose = static_cast<uint32_t>(world.bodies.size());
    for (size_t i = 0; i < places.size(); ++i)
        places[i].x = world.particles[i].body != NO_INDEX ? world.particles[i].body : loose++;
    std::vector<uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return places[a].x < places[b].x; });
    for (uint32_t rank = 0; rank < order.size(); ++rank) {
        places[order[rank]].y = rank;
        gpu::MoverInfo& mover = movers.infos[places[order[rank]].x];
        if (mover.rankCount++ == 0) mover.firstRank = rank;
    }
    out.particleRanks = {"particleRanks", std::span<const gpu::uvec2>(places)};
    out.rankedParticles = {"rankedParticles", std::span<const uint32_t>(order)};
}

}  // namespace

void uploadMovers(SolverBuffers& out, const World& world)
{
    Movers movers = makeMovers(world, world.assemblyCount);
    rankParticles(out, world, movers);
    const size_t count = movers.infos.size(), fields = movers.velocities.size();
    const std::vector<gpu::vec4> unturned(count, gpu::vec4{0, 0, 0, 1});
    out.moverInfo = {"moverInfo", std::span<const gpu::MoverInfo>(movers.infos)};
    out.moverStates = {"moverStates", std::span<const uint32_t>(movers.states)};
    out.bodyMoments = {"bodyMoments", std::span<const gpu::vec4>(movers.moments)};
    out.bodyInertias = {"bodyInertias", std::span<const gpu::vec4>(movers.inertias)};
    out.moverCentres = {"moverCentres", std::span<const gpu::vec4>(movers.centres)};
    out.moverRotations = {"moverRotations", std::span<const gpu::vec4>(movers.rotations)};
    out.moverVelocities = {"moverVelocities", std::span<const gpu::vec4>(movers.velocities)};
    out.oldMoverVelocities = {"oldMoverVelocities", std::span<const gpu::vec4>(movers.velocities)};
    out.oldMoverMoves = {"oldMoverMoves", fields};
    out.moverMoves = {"moverMoves", count};
    out.moverRotationDeltas = {"moverRotationDeltas", std::span<const gpu::vec4>(unturned)};
    out.moverPredictions = {"moverPredictions", fields};
    out.moverImpulses = {"moverImpulses", fields};
    const std::vector<gpu::vec4> changes(fields, gpu::vec4{0, 0, 0, INITIAL_RELAXATION});
    out.moverChanges = {"moverChanges", std::span<const gpu::vec4>(changes)};
    // All of them, for a solver that does not look which are near.
    const uint32_t colliders = out.parameters.colliderCount;
    const std::vector<uint32_t> all(count, colliders < 32 ? (1u << colliders) - 1u : ~0u);
    out.moverColliders = {"moverColliders", std::span<const uint32_t>(all)};
    out.particleImpulses = {"particleImpulses", world.particles.size()};
    out.moverRestitutionSplits = {"moverRestitutionSplits", count};
    out.moverReaches = {"moverReaches", count};
    out.calmCentres = {"calmCentres", count};
    out.calmRotations = {"calmRotations", std::span<const gpu::vec4>(unturned)};
    out.searchCentres = {"searchCentres", count};
    out.searchRotations = {"searchRotations", std::span<const gpu::vec4>(unturned)};
}

void uploadSleep(SolverBuffers& out)
{
    const uint32_t count = out.parameters.assemblyCount;
    std::vector<gpu::uvec2> awake(count), next(count);
    for (uint32_t a = 0; a < count; ++a) {
        awake[a] = {0, a};
        next[a] = {out.parameters.calmSteps, a};
    }
    out.assemblyCalm = {"assemblyCalm", std::span<const gpu::uvec2>(awake)};
    out.assemblyNext = {"assemblyNext", std::span<const gpu::uvec2>(next)};
    out.islandsWoken = {"islandsWoken", count};
}

}  // namespace knuckle
