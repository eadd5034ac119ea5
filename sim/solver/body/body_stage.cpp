#include "sim/solver/body/body_stage.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "shared/contact_constants.h"
#include "shared/joint_records.h"
#include "sim/solver/contact/stack_stage.h"
#include "sim/solver/layout/body_mass.h"
#include "sim/solver/layout/cluster_links.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Arrays per mover, bodies first.
struct Movers {
    std::vector<gpu::Mover> infos;
    std::vector<uint32_t> states;
    std::vector<gpu::vec4> centres, rotations, velocities;  ///< The last: fields.
    std::vector<gpu::vec4> moments, inertias, rounds;       ///< Of bodies.
};

/// Adds the velocity field of a body: its particles move as the linear field nearest to their velocities (least
/// squares).
void addVelocityField(std::vector<gpu::vec4>& out, const World& world, const Body& body, const BodyMass& mass)
{
    Vector3d momentum = Vector3d::Zero();
    Matrix3d cross = Matrix3d::Zero(), moments = Matrix3d::Zero();  // of the particles, even for a ball or capsule
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
        const Vector3d v = world.links[l].mass * world.particles[world.links[l].particle].velocity.cast<double>();
        momentum += v;
        const Vector3d r = world.links[l].restOffset.cast<double>();
        cross += v * r.transpose();
        moments += world.links[l].mass * r * r.transpose();
    }
    const bool fixed = body.motion == Motion::Fixed;
    out.push_back(pack(fixed ? Vector3f::Zero() : Vector3f((momentum / mass.mass).cast<float>()), 0));
    const Matrix3d f = moments.completeOrthogonalDecomposition().solve(cross.transpose()).transpose();
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

void addRound(Movers& out, const World& world, const Body& body)
{
    const Vector3f end(0, body.round.halfHeight, 0);
    out.rounds.push_back(pack(-end - body.restCentre, body.round.radius));
    out.rounds.push_back(pack(end - body.restCentre, world.materials[body.material].rollingFriction));
}

uint32_t stateOf(Motion motion)
{
    if (motion == Motion::Animated) return MOVER_ANIMATED;
    return motion == Motion::Fixed ? MOVER_FIXED : MOVER_DYNAMIC;
}

void addBody(Movers& out, const World& world, const Body& body)
{
    const BodyMass mass = bodyMass(world, body);
    out.infos.push_back({0, 0, body.assembly, static_cast<float>(1.0 / mass.mass)});
    out.states.push_back(stateOf(body.motion));
    addMass(out, mass);
    addRound(out, world, body);
    out.centres.push_back(pack(body.position + awayFrom(world, body), 0));
    out.rotations.push_back(pack(body.rotation));
    addVelocityField(out.velocities, world, body, mass);
}

Movers makeMovers(const World& world, const Layout& layout)
{
    Movers movers;
    for (const Body& body : world.bodies) addBody(movers, world, body);
    for (uint32_t i = 0; i < layout.solidCount; ++i) {
        const Particle& p = world.particles[i];
        if (p.body != NO_INDEX) continue;
        movers.infos.push_back({0, 0, layout.assemblies[i], 1.0f / p.mass});
        movers.states.push_back(p.pinned ? MOVER_FIXED : MOVER_DYNAMIC);
        movers.centres.push_back(pack(p.position, (p.scale - 1.0f) * world.particleRadius));
        movers.rotations.push_back({0, 0, 0, 1});
        movers.velocities.push_back(pack(p.pinned ? Vector3f(0, 0, 0) : p.velocity, 0));
    }
    for (size_t m = 0; m < movers.infos.size(); ++m) {
        movers.infos[m].firstRank = layout.moverRanks[m].x;
        movers.infos[m].rankCount = layout.moverRanks[m].y;
    }
    return movers;
}

/// How a held body is let go: its velocity field, and its centre.
void addThrow(std::vector<gpu::vec4>& out, const Body& body)
{
    const Eigen::Matrix3f turned = body.rotation.toRotationMatrix();
    out.push_back(pack(body.throwVelocity, 0));
    for (int column = 0; column < 3; ++column)
        out.push_back(pack(body.throwSpin.cross(Vector3f(turned.col(column))), 0));
    out.push_back(pack(body.position, 0));
}

/// The first substep in which a body responds; NO_SUBSTEP if it is not held or animated until a time.
uint32_t releaseOf(const World& world, const Body& body)
{
    return world.settings.substepAt(body.releaseTime);
}

}  // namespace

BodyStage::BodyStage(const StageSetup& setup, bool onParticles)
    : parameters_(setup.parameters), onParticles_(onParticles),
      solves_(setup.world.settings.solver == SolverKind::Impulse),
      hasFree_(solves_ && !setup.layout.freeBodies.empty()),
      hasJointed_(solves_ && !setup.layout.jointedBodies.empty()), hasLoose_(solves_ && setup.layout.looseCount > 0),
      releases_(solves_ && !setup.layout.heldBodies.empty()),
      throws_(std::ranges::any_of(setup.world.bodies, isThrown)),
      stacks_(StackStage::isNeeded(setup.world, setup.layout)), onParticle_(definesOf({{"ON_PARTICLES", onParticles}})),
      warm_(definesOf({{"WARM_START", true}})), angular_(definesOf({{"ANGULAR", setup.rows.hasAngular()}})),
      jointed_(definesOf({{"ON_PARTICLES", onParticles}, {"ANGULAR", setup.rows.hasAngular()}})),
      thrown_(definesOf({{"THROWS", throws_}}))
{
}

void BodyStage::upload(const StageSetup& setup)
{
    uploadLinks(setup);
    uploadMovers(setup);
    uploadRows(setup.rows);
    particleImpulses = {"particleImpulses", setup.world.particles.size()};
    setup.parameters.rotationIterations = 3;
}

void BodyStage::uploadLinks(const StageSetup& setup)
{
    const World& world = setup.world;
    const Layout& layout = setup.layout;
    std::vector<gpu::ParticleRigidBodyLink> all;
    for (uint32_t l : layout.linkOrder) {
        const Link& link = world.links[l];
        const Body& body = world.bodies[link.body];
        const Vector3f& r = link.restOffset;
        all.push_back({link.particle, link.body, r.x(), r.y(), r.z(), body.linkStart, body.linkCount, link.mass});
    }
    appendClusterLinks(all, world);
    std::vector<gpu::uvec2> ranges, inverse;
    for (const auto& owned : layout.owners) {
        ranges.push_back({static_cast<uint32_t>(inverse.size()), static_cast<uint32_t>(owned.size())});
        for (const Layout::Owner& owner : owned) inverse.push_back({owner.link, owner.body});
    }
    std::vector<gpu::Body> infos;
    for (const Body& body : world.bodies) {
        const uint32_t own = layout.ownLinkCounts[infos.size()];
        infos.push_back({body.linkStart, body.linkCount, own, body.linkCount - own});
    }
    std::vector<uint32_t> order = layout.freeBodies;
    order.insert(order.end(), layout.jointedBodies.begin(), layout.jointedBodies.end());
    bodyOrder = {"bodyOrder", std::span<const uint32_t>(order)};
    links = {"links", std::span<const gpu::ParticleRigidBodyLink>(all)};
    particleLinks = {"particleLinks", std::span<const gpu::uvec2>(ranges)};
    linksOfParticle = {"linksOfParticle", std::span<const gpu::uvec2>(inverse)};
    bodyInfo = {"bodyInfo", std::span<const gpu::Body>(infos)};
}

void BodyStage::uploadMovers(const StageSetup& setup)
{
    const Movers movers = makeMovers(setup.world, setup.layout);
    const size_t count = movers.infos.size(), fields = movers.velocities.size();
    const std::vector<gpu::vec4> unturned(count, gpu::vec4{0, 0, 0, 1});
    const std::vector<gpu::vec4> changes(fields, gpu::vec4{0, 0, 0, INITIAL_RELAXATION});
    moverInfo = {"moverInfo", std::span<const gpu::Mover>(movers.infos)};
    std::vector<gpu::uvec2> releases;
    std::vector<gpu::vec4> throws;
    for (const uint32_t b : setup.layout.heldBodies) {
        releases.push_back({b, releaseOf(setup.world, setup.world.bodies[b])});
        if (throws_) addThrow(throws, setup.world.bodies[b]);
    }
    bodyThrows = {"bodyThrows", std::span<const gpu::vec4>(throws)};
    setup.parameters.releaseCount = static_cast<uint32_t>(releases.size());
    bodyReleases = {"bodyReleases", std::span<const gpu::uvec2>(releases)};
    moverStates = {"moverStates", std::span<const uint32_t>(movers.states)};
    bodyMoments = {"bodyMoments", std::span<const gpu::vec4>(movers.moments)};
    bodyInertias = {"bodyInertias", std::span<const gpu::vec4>(movers.inertias)};
    bodyRounds = {"bodyRounds", std::span<const gpu::vec4>(movers.rounds)};
    moverCentres = {"moverCentres", std::span<const gpu::vec4>(movers.centres)};
    moverRotations = {"moverRotations", std::span<const gpu::vec4>(movers.rotations)};
    moverVelocities = {"moverVelocities", std::span<const gpu::vec4>(movers.velocities)};
    oldMoverVelocities = {"oldMoverVelocities", std::span<const gpu::vec4>(movers.velocities)};
    std::vector<gpu::vec4> moves;  // before the first substep, for what is animated
    for (const gpu::vec4& v : movers.velocities) {
        const float h = setup.parameters.substepTime;
        moves.push_back({h * v.x, h * v.y, h * v.z, 0});
    }
    oldMoverMoves = {"oldMoverMoves", std::span<const gpu::vec4>(moves)};
    moverMoves = {"moverMoves", count};
    bodyLoads = {"bodyLoads", setup.layout.jointedBodies.empty() ? 0u : BODY_LOAD_TEXELS * setup.layout.bodyCount};
    bodyPushes = {"bodyPushes", 4 * size_t{setup.layout.bodyCount}};
    bodyParticlePushes = {"bodyParticlePushes", onParticles_ ? 4 * size_t{setup.layout.bodyCount} : 0};
    moverRotationDeltas = {"moverRotationDeltas", std::span<const gpu::vec4>(unturned)};
    moverPredictions = {"moverPredictions", fields};
    moverImpulses = {"moverImpulses", fields};
    moverChanges = {"moverChanges", std::span<const gpu::vec4>(changes)};
}

void BodyStage::uploadRows(const RowPlan& rows)
{
    std::vector<gpu::vec4> arms;
    for (const Vector3f& arm : rows.arms()) arms.push_back(pack(arm, 0));
    bodyRows = {"bodyRows", std::span<const gpu::uvec2>(rows.bodies())};
    rowArms = {"rowArms", std::span<const gpu::vec4>(arms)};
    rowImpulses = {"rowImpulses", arms.size()};
    rowImpulses.clear();
    rowAngularImpulses = {"rowAngularImpulses", rows.hasAngular() ? arms.size() : 0};
    rowAngularImpulses.clear();
}

void BodyStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, links, linksOfParticle, bodyInfo, bodyOrder, bodyMoments, bodyInertias, bodyRounds,
              bodyThrows, moverInfo, bodyRows, rowArms);
    table.add(Lifetime::State, particleLinks, bodyReleases, moverStates, moverCentres, moverRotations, moverVelocities,
              oldMoverVelocities, oldMoverMoves, moverMoves, moverRotationDeltas, moverImpulses, moverChanges,
              rowImpulses, rowAngularImpulses);
    table.add(Lifetime::Scratch, moverPredictions, particleImpulses, bodyPushes, bodyParticlePushes, bodyLoads);
}

void BodyStage::predict(Recorder& recorder) const
{
    recorder.perElement(release_, parameters_.releaseCount);
    recorder.perElement(predictFree_, parameters_.freeBodyCount);
    recorder.perElement(predictJointed_, parameters_.jointedBodyCount);
    recorder.perElement(predictLoose_, looseCount());
    if (onParticles_) recorder.perElement(clear_, parameters_.particleCount);
}

void BodyStage::warmStart(Recorder& recorder) const
{
    if (hasFree_ || hasJointed_) recorder.decided(sumWarm_, DISPATCH_MOVERS);
    if (hasFree_) recorder.decided(solveFreeWarm_, DISPATCH_MOVERS);
    if (hasJointed_) recorder.decided(solveJointedWarm_, DISPATCH_MOVERS);
    if (hasLoose_) recorder.decided(solveLooseWarm_, DISPATCH_MOVERS);
}

void BodyStage::solve(Recorder& recorder, bool again) const
{
    if (hasFree_ || hasJointed_) recorder.perElement(sum_, parameters_.bodyCount);
    recorder.perElement(again && stacks_ ? solveFreeAgain_ : solveFree_, parameters_.freeBodyCount);
    recorder.perElement(solveJointed_, parameters_.jointedBodyCount);
    recorder.perElement(solveLoose_, looseCount());
}

void BodyStage::integrate(Recorder& recorder) const
{
    recorder.perElement(integrateFree_, parameters_.freeBodyCount);
    recorder.perElement(integrateJointed_, parameters_.jointedBodyCount);
    recorder.perElement(integrateLoose_, looseCount());
}

uint32_t BodyStage::looseCount() const
{
    return parameters_.moverCount - parameters_.bodyCount;
}

void BodyStage::placeParticles(Recorder& recorder) const
{
    recorder.perElement(place_, parameters_.particleCount);
}

}  // namespace knuckle
