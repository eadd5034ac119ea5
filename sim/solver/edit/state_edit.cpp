#include "sim/solver/edit/state_edit.h"

#include <algorithm>
#include <optional>

#include "shared/constants.h"
#include "shared/counters.h"
#include "sim/solver/edit/clump.h"
#include "sim/solver/layout/body_mass.h"
#include "sim/solver/pack.h"
#include "sim/solver/state_values.h"

namespace knuckle {

namespace {

using Eigen::Isometry3f;
using Eigen::Matrix3f;

/// The fourth value stays.
void put(gpu::vec4& to, const Vector3f& v)
{
    to.x = v.x(), to.y = v.y(), to.z = v.z();
}

Matrix3f crossOf(const Vector3f& v)
{
    return Matrix3f{{0, -v.z(), v.y()}, {v.z(), 0, -v.x()}, {-v.y(), v.x(), 0}};
}

/// The linear part of a body's field.
Matrix3f slopeOf(const std::vector<gpu::vec4>& fields, uint32_t body)
{
    Matrix3f slope;
    for (int k = 0; k < 3; ++k) slope.col(k) = vectorOf(fields[4 * size_t{body} + 1 + static_cast<size_t>(k)]);
    return slope;
}

void putSlope(std::vector<gpu::vec4>& fields, uint32_t body, const Matrix3f& slope)
{
    for (int k = 0; k < 3; ++k) put(fields[4 * size_t{body} + 1 + static_cast<size_t>(k)], slope.col(k));
}

std::vector<gpu::uvec2> calmOf(const StagesState& state)
{
    if (!state.buffers.contains("assemblyCalm")) return {};
    return readState<gpu::uvec2>(state, "assemblyCalm");
}

}  // namespace

StateEdit::StateEdit(const World& world, const Layout& layout, StagesState& state)
    : world_(world), layout_(layout), state_(state), positions_(readState<gpu::vec4>(state, "positions")),
      velocities_(readState<gpu::vec4>(state, "velocities")), centres_(readState<gpu::vec4>(state, "moverCentres")),
      rotations_(readState<gpu::vec4>(state, "moverRotations")),
      fields_(readState<gpu::vec4>(state, "moverVelocities")), impulses_(readState<gpu::vec4>(state, "moverImpulses")),
      movers_(readState<uint32_t>(state, "moverStates")), assemblies_(readState<gpu::uvec2>(state, "assemblyState")),
      calm_(calmOf(state)), substep_(readState<gpu::Counters>(state, "countersBlock").at(0).substep)
{
}

bool StateEdit::responds(uint32_t body) const
{
    return movers_[body] == MOVER_DYNAMIC || movers_[body] == MOVER_ASLEEP;
}

bool StateEdit::freeNow(uint32_t body)
{
    if (responds(body)) return true;
    if (movers_[body] != MOVER_FIXED || layout_.heldIndex(body) == NO_INDEX) return false;
    movers_[body] = MOVER_DYNAMIC;
    for (const uint32_t i : particlesOf({{body}})) positions_[i].w = 0.0f;
    wake(body, world_.bodies[body].assembly);
    return true;
}

Isometry3f StateEdit::pose(uint32_t body) const
{
    const gpu::vec4& q = rotations_[body];
    Isometry3f pose = Isometry3f::Identity();
    pose.linear() = Quaternionf(q.w, q.x, q.y, q.z).toRotationMatrix();
    pose.translation() = vectorOf(centres_[body]);
    return pose;
}

std::vector<uint32_t> StateEdit::particlesOf(std::span<const uint32_t> bodies) const
{
    const auto isOurs = [&](const Layout::Owner& owner) {
        return std::ranges::find(bodies, owner.body) != bodies.end();
    };
    std::vector<uint32_t> particles;
    for (uint32_t i = 0; i < layout_.owners.size(); ++i)
        if (!layout_.owners[i].empty() && std::ranges::all_of(layout_.owners[i], isOurs)) particles.push_back(i);
    return particles;
}

void StateEdit::wake(uint32_t mover, uint32_t assembly)
{
    beginAnew(assembly);
    if (movers_[mover] != MOVER_ASLEEP) return;
    for (uint32_t b = 0; b < layout_.bodyCount; ++b)
        if (world_.bodies[b].assembly == assembly && movers_[b] == MOVER_ASLEEP) movers_[b] = MOVER_DYNAMIC;
    for (uint32_t i = 0; i < layout_.solidCount; ++i) {
        uint32_t& state = movers_[layout_.ranks[i].mover];
        if (layout_.assemblies[i] == assembly && state == MOVER_ASLEEP) state = MOVER_DYNAMIC;
    }
}

void StateEdit::wakeAll()
{
    for (uint32_t& mover : movers_)
        if (mover == MOVER_ASLEEP) mover = MOVER_DYNAMIC;
    for (uint32_t a = 0; a < assemblies_.size(); ++a) beginAnew(a);
}

void StateEdit::beginAnew(uint32_t assembly)
{
    // Velocities are of first order in the next substep, since nothing is known of the one before.
    assemblies_[assembly].x = substep_ > 0 ? substep_ - 1 : NO_SUBSTEP;
    if (assembly < calm_.size()) calm_[assembly] = {0, assembly};
}

void StateEdit::move(std::span<const uint32_t> bodies, const Isometry3f& motion)
{
    for (const uint32_t body : bodies) {
        const Isometry3f before = pose(body), now = motion * before;
        put(centres_[body], now.translation());
        rotations_[body] = pack(Quaternionf(now.linear()).normalized());
        putSlope(fields_, body, slopeOf(fields_, body) * before.linear().transpose() * now.linear());
        // What its contacts were stays behind.
        for (size_t k = 0; k < 4; ++k) put(impulses_[4 * size_t{body} + k], Vector3f::Zero());
        wake(body, world_.bodies[body].assembly);
    }
    for (const uint32_t i : particlesOf(bodies)) put(positions_[i], motion * vectorOf(positions_[i]));
}

void StateEdit::setVelocity(std::span<const uint32_t> bodies, const RigidVelocity& given, bool added)
{
    const float kept = added ? 1.0f : 0.0f;
    for (const uint32_t body : bodies) {
        const Isometry3f place = pose(body);
        gpu::vec4& middle = fields_[4 * size_t{body}];
        put(middle, kept * vectorOf(middle) + given.at(place.translation()));
        putSlope(fields_, body, kept * slopeOf(fields_, body) + crossOf(given.spin) * place.linear());
        wake(body, world_.bodies[body].assembly);
    }
    for (const uint32_t i : particlesOf(bodies))
        put(velocities_[i], kept * vectorOf(velocities_[i]) + given.at(vectorOf(positions_[i])));
}

void StateEdit::setParticleVelocity(uint32_t particle, const Vector3f& velocity)
{
    if (world_.particles[particle].pinned) return;
    put(velocities_[particle], velocity);
    if (particle >= layout_.solidCount) return;
    const uint32_t mover = layout_.ranks[particle].mover;
    put(fields_[3 * size_t{layout_.bodyCount} + mover], velocity);
    wake(mover, layout_.assemblies[particle]);
}

void StateEdit::push(uint32_t body, const Vector3f& impulse, const Vector3f& at)
{
    const BodyMass mass = bodyMass(world_, world_.bodies[body]);
    const Isometry3f place = pose(body);
    const Matrix3f inverse = place.linear() * mass.inverseInertia.cast<float>() * place.linear().transpose();
    const Vector3f angular = Vector3f(at - place.translation()).cross(impulse);
    setVelocity({{body}}, {impulse / static_cast<float>(mass.mass), inverse * angular, place.translation()}, true);
}

bool StateEdit::stir(uint32_t first, uint32_t end, const Vector3f& impulse, const Vector3f& at, float radius)
{
    const Clump clump = clumpAround(world_, first, end, at, radius, [&](uint32_t i) -> std::optional<Vector3f> {
        if (positions_[i].w != 0.0f) return {};
        return vectorOf(positions_[i]);
    });
    for (const auto& [particle, share] : clump.shares)
        setParticleVelocity(particle, vectorOf(velocities_[particle]) + share / clump.mass * impulse);
    return !clump.empty();
}

bool StateEdit::letGo(std::span<const uint32_t> bodies)
{
    const auto isHeldForEver = [&](uint32_t body) { return !responds(body) && layout_.heldIndex(body) == NO_INDEX; };
    if (std::ranges::any_of(bodies, isHeldForEver)) return false;
    if (!state_.buffers.contains("bodyReleases")) return true;
    auto releases = readState<gpu::uvec2>(state_, "bodyReleases");
    for (const uint32_t body : bodies)
        if (const uint32_t entry = layout_.heldIndex(body); entry != NO_INDEX && !responds(body))
            releases[entry].y = std::min(releases[entry].y, substep_);
    writeState(state_, "bodyReleases", releases);
    makeLimp(bodies);
    return true;
}

void StateEdit::makeLimp(std::span<const uint32_t> bodies)
{
    if (!state_.buffers.contains("limpSubsteps")) return;
    auto limp = readState<gpu::uvec4>(state_, "limpSubsteps");
    for (const Puppet& puppet : world_.puppets)
        for (const uint32_t body : bodies) {
            const Object& object = objectOf(world_, puppet);
            if (!object.has(body)) continue;
            // As shaders/sim/release/release.glsl: before it is caught, or after.
            gpu::uvec4& when = limp[layout_.firstAnimated[puppet.animation] + body - object.bodyStart];
            uint32_t& next = substep_ < when.z ? when.x : when.y;
            next = std::min(next, substep_);
        }
    writeState(state_, "limpSubsteps", limp);
}

void StateEdit::commit()
{
    writeState(state_, "positions", positions_);
    writeState(state_, "velocities", velocities_);
    writeState(state_, "moverCentres", centres_);
    writeState(state_, "moverRotations", rotations_);
    writeState(state_, "moverVelocities", fields_);
    writeState(state_, "moverImpulses", impulses_);
    writeState(state_, "moverStates", movers_);
    writeState(state_, "assemblyState", assemblies_);
    if (!calm_.empty()) writeState(state_, "assemblyCalm", calm_);
    auto counters = readState<gpu::Counters>(state_, "countersBlock");
    counters[0].due = counters[0].freeMoved = 1;
    writeState(state_, "countersBlock", counters);
}

}  // namespace knuckle
