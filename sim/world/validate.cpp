#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

/// For errors that only code can make, including ranges of single values. For scene files the schema has checked those,
/// with their place in the file; here they are checked for code that fills a World.
template <typename... Args>
void require(bool holds, fmt::format_string<Args...> format, Args&&... args)
{
    if (!holds) throw std::logic_error(fmt::format(format, std::forward<Args>(args)...));
}

/// For errors that a scene file can cause with all values in range: some do not fit together, others are rounded to 0.
template <typename... Args>
void requireInput(bool holds, fmt::format_string<Args...> format, Args&&... args)
{
    if (!holds) throw InputError(fmt::format(format, std::forward<Args>(args)...));
}

bool within(float value, float low, float high)
{
    return value >= low && value <= high;  // false for NaN
}

void validateSettings(const Settings& s)
{
    require(within(s.timeStep, SHORTEST_TIME_STEP, 0.1f), "solver time step {} s: must be 0.0001 to 0.1", s.timeStep);
    require(s.substeps >= 1 && s.substeps <= 64, "solver substeps {}: must be 1 to 64", s.substeps);
    require(s.iterations >= 1 && s.iterations <= 64, "solver iterations {}: must be 1 to 64", s.iterations);
    require(s.stabilization <= 16, "solver stabilization {}: must be 0 to 16", s.stabilization);
    require(within(s.contactMargin, 0.05f, 1.0f), "solver contact margin {}: must be 0.05 to 1", s.contactMargin);
    require(within(s.freeze, 0.0f, 0.8f), "solver freeze {}: must be 0 to 0.8 radii", s.freeze);
    requireInput(s.freeze == 0.0f || s.sleepSpeed == 0.0f,
                 "solver: freeze and sleep do the same; set one of them to 0");
    require(within(s.virtualParticles, 0.0f, 1.0f), "solver virtual particles {}: must be 0 to 1", s.virtualParticles);
    require(within(s.linearDamping, 0.0f, 100.0f), "solver damping {} 1/s: must be 0 to 100", s.linearDamping);
    requireInput(s.maxSpeed > 0.0f, "solver maximum speed {} m/s: must be above 0", s.maxSpeed);
    require(within(s.massScaling, 0.0f, 10.0f), "solver mass scaling {} 1/m: must be 0 to 10", s.massScaling);
    require(within(s.vorticity, 0.0f, 1.0f), "solver vorticity {}: must be 0 to 1", s.vorticity);
    require(within(s.sleepSpeed, 0.0f, 10.0f), "solver sleep speed {} m/s: must be 0 to 10", s.sleepSpeed);
    require(s.gravity.allFinite(), "gravity must be finite");
    const bool paper = s.solver == SolverKind::Paper;
    requireInput(!paper || s.sleepSpeed == 0.0f,
                 "the paper's solver has no sleep; use solver freeze, or method impulse");
    requireInput(paper || s.reduction == ReductionKind::Auto,
                 "solver reduction is the paper's solver's; use reduction auto, or method paper");
    requireInput(paper || s.stabilization == 0, "solver stabilization is the paper's solver's; use 0, or method paper");
}

void validateMaterials(const World& world)
{
    for (const Material& m : world.materials) {
        requireInput(m.density > 0.0f && std::isfinite(m.density), "material \"{}\": density {} kg/m3 must be above 0",
                     m.name, m.density);
        require(m.kineticFriction >= 0.0f && m.kineticFriction <= m.staticFriction,
                "material \"{}\": kinetic friction {} must be 0 to its static friction {}", m.name, m.kineticFriction,
                m.staticFriction);
        require(within(m.viscosity, 0.0f, 1e6f), "material \"{}\": viscosity {} Pa s must be 0 to 1e6", m.name,
                m.viscosity);
        require(within(m.slip, 0.0f, 1e4f), "material \"{}\": slip length {} m must be 0 to 10000", m.name, m.slip);
        require(within(m.surfaceTension, 0.0f, 1e5f), "material \"{}\": surface tension {} N/m must be 0 to 100000",
                m.name, m.surfaceTension);
        require(within(m.look.absorption, 0.0f, 1e4f) && within(m.look.scattering, 0.0f, 1e4f),
                "material \"{}\": absorption {} and scattering {} 1/m must be 0 to 10000", m.name, m.look.absorption,
                m.look.scattering);
        require(within(m.look.emission, 0.0f, 1e3f) && within(m.finish.emission, 0.0f, 1e3f),
                "material \"{}\": emission must be 0 to 1000", m.name);
        require(within(m.look.foam, 0.0f, 100.0f), "material \"{}\": foam {} must be 0 to 100", m.name, m.look.foam);
        require(within(m.restitution, 0.0f, 1.0f), "material \"{}\": restitution {} must be 0 to 1", m.name,
                m.restitution);
        requireInput(m.restitution == 0.0f || world.settings.solver == SolverKind::Impulse,
                     "material \"{}\": the paper's solver has no restitution; use 0, or solver method impulse", m.name);
        require(within(m.rollingFriction, 0.0f, 1.0f), "material \"{}\": rolling friction {} must be 0 to 1", m.name,
                m.rollingFriction);
        requireInput(m.rollingFriction == 0.0f || world.settings.solver == SolverKind::Impulse,
                     "material \"{}\": the paper's solver has no rolling friction; use 0, or solver method impulse",
                     m.name);
    }
}

void validateFluids(const World& world)
{
    if (world.fluidCount == 0) return;
    require(within(world.fluidSpacing / world.diameter(), 0.299f, 0.601f),
            "fluid spacing {} m: must be 0.3 to 0.6 of the diameter, {} m", world.fluidSpacing, world.diameter());
    requireInput(world.settings.solver == SolverKind::Impulse,
                 "the paper's solver has no fluids; use solver \"impulse\"");
    for (const Material& m : world.materials) {
        // A fluid that its tension compresses by more than about 3 % jitters (see automaticFluidSubsteps).
        const float way = world.settings.timeStep / (float(world.settings.substeps) * world.fluidSpacing);
        const float most = 0.06f * m.density / (way * way);
        requireInput(
            !m.fluid || cohesionPressure(m.surfaceTension, world.fluidSpacing) < most,
            "material \"{}\": a surface tension of {} N/m jitters with {} substeps: at most {:.3g}, or raise them",
            m.name, m.surfaceTension, world.settings.substeps, most / cohesionPressure(1.0f, world.fluidSpacing));
    }
    for (size_t i = 0; i < world.particles.size(); ++i)
        require(world.materials[world.particles[i].material].fluid == (i >= world.solidCount()),
                "particle {}: fluids come behind all others, and nothing else is of a fluid's material", i);
}

void validateEmitters(const World& world)
{
    for (size_t i = 0; i < world.emitters.size(); ++i) {
        const Emitter& e = world.emitters[i];
        const size_t layer = e.nozzle.points.size();
        require(layer > 0 && e.nozzle.layerSpacing > 0.0f, "emitter {}: its nozzle holds no particle", i);
        require(e.velocity.allFinite() && e.velocity.norm() > 0.0f, "emitter {}: its speed must be above 0", i);
        require(e.velocity.norm() <= world.settings.maxSpeed,
                "emitter {}: its speed, {} m/s, is above the solver's maximum, {} m/s", i, e.velocity.norm(),
                world.settings.maxSpeed);
        require(e.start >= 0.0 && e.stop >= e.start, "emitter {}: stops at {} s and starts at {} s", i, e.stop,
                e.start);
        require(e.pool >= layer, "emitter {}: its pool of {} is smaller than a layer of {} particles", i, e.pool,
                layer);
    }
    for (const Region& drain : world.drains)
        require(drain.shape <= ColliderShape::Capsule, "a drain is a plane, a box, a sphere or a capsule");
}

void validateParticles(const World& world)
{
    for (size_t i = 0; i < world.particles.size(); ++i) {
        const Particle& p = world.particles[i];
        require(p.position.allFinite() && p.velocity.allFinite(), "particle {}: position or velocity is not finite", i);
        requireInput(p.mass > 0.0f && std::isfinite(p.mass), "particle {}: mass {} kg must be above 0", i, p.mass);
        require(p.material < world.materials.size(), "particle {}: there is no material {}", i, p.material);
        require(p.body == NO_INDEX || p.body < world.bodies.size(), "particle {}: there is no body {}", i, p.body);
        require(p.body == NO_INDEX ? within(p.scale, 0.8f, 1.2f) : p.scale == 1.0f,
                "particle {}: scale {} must be 0.8 to 1.2, in a body 1", i, p.scale);
    }
}

void validateLinks(const World& world)
{
    std::vector<uint32_t> bodiesOf(world.particles.size(), 0);
    size_t next = 0;
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        const Body& body = world.bodies[b];
        require(body.linkStart == next && body.linkCount > 0, "body \"{}\": its links are not one block", body.name);
        next += body.linkCount;
        require(next <= world.links.size(), "body \"{}\": its links reach beyond the array", body.name);
        require(body.rotation.coeffs().allFinite() && std::abs(body.rotation.norm() - 1.0f) < 1e-3f,
                "body \"{}\": its rotation is not a unit quaternion", body.name);
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const Link& link = world.links[l];
            require(link.body == b && link.particle < world.particles.size(), "link {}: body or particle is wrong", l);
            requireInput(link.mass > 0.0f, "link {}: mass {} kg must be above 0", l, link.mass);
            ++bodiesOf[link.particle];
        }
    }
    require(next == world.links.size(), "there are links of no body");
    for (uint32_t b = 0; b < world.bodies.size(); ++b)
        for (const uint32_t other : world.bodies[b].filtered)
            require(other < world.bodies.size() && world.bodies[b].object < world.objects.size() &&
                        world.objects[world.bodies[b].object].has(other) && areFiltered(world, other, b),
                    "body \"{}\" passes through one that is not of its object, or does not say so of it",
                    world.bodies[b].name);
    for (size_t i = 0; i < bodiesOf.size(); ++i)
        require(bodiesOf[i] == world.particles[i].bodyCount, "particle {}: {} links name it, but it counts {} bodies",
                i, bodiesOf[i], world.particles[i].bodyCount);
}

void validateReleases(const World& world)
{
    for (const Strand& strand : world.strands)
        for (const uint32_t p : strand.particles)
            requireInput(world.particles[p].body == NO_INDEX || !world.bodies[world.particles[p].body].absent,
                         "a rope or cloth is tied to what is not there before its release; take `appears` away");
    for (const Joint& joint : world.joints)
        for (const uint32_t b : {joint.parent, joint.child})
            requireInput(b == NO_INDEX || !world.bodies[b].absent,
                         "a joint holds \"{}\", which is not there before its release; take `appears` away",
                         b == NO_INDEX ? "" : world.objects[world.bodies[b].object].name);
    for (const Body& body : world.bodies) {
        require(body.releaseTime >= 0.0f, "body \"{}\": it is let go at {} s; must be 0 or later", body.name,
                body.releaseTime);
        require(!isThrown(body) || (body.motion == Motion::Fixed && std::isfinite(body.releaseTime)),
                "body \"{}\": it is thrown, but is not held until a time", body.name);
        require(body.throwVelocity.allFinite() && body.throwSpin.allFinite(),
                "body \"{}\": it is thrown at no finite velocity", body.name);
        requireInput((std::isinf(body.releaseTime) && !body.watched) || world.settings.solver == SolverKind::Impulse,
                     "the paper's solver lets nothing go; take `release` away, or use solver method impulse");
    }
    for (const Release& release : world.releases) {
        require(!release.bodies.empty() && release.impulse >= 0.0f && std::isfinite(release.impulse) &&
                    release.firstParticle <= release.endParticle && release.endParticle <= world.solidCount() &&
                    release.region.shape <= ColliderShape::Capsule && release.region.position.allFinite(),
                "a release has no bodies, or values out of range");
        for (const uint32_t b : release.bodies)
            require(b < world.bodies.size() && world.bodies[b].watched &&
                        world.bodies[b].object == world.bodies[release.bodies[0]].object,
                    "a release has bodies that are not of one object");
    }
}

void validateColliders(const World& world)
{
    for (size_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& c = world.colliders[i];
        require(c.position.allFinite() && std::abs(c.orientation.norm() - 1.0f) < 1e-3f,
                "collider {}: position or orientation is not finite", i);
        requireInput(c.halfExtents.minCoeff() > 0.0f && c.radius > 0.0f && c.halfHeight >= 0.0f,
                     "collider {}: sizes must be above 0", i);
        const bool hasGrid = c.shape == ColliderShape::Mesh || c.shape == ColliderShape::Heightfield;
        require(!hasGrid || c.grid < world.colliderGrids.size(), "collider {}: there is no grid {}", i, c.grid);
        require(c.kineticFriction >= 0.0f && c.kineticFriction <= c.staticFriction,
                "collider {}: kinetic friction {} must be 0 to its static friction {}", i, c.kineticFriction,
                c.staticFriction);
    }
}

void validateGrids(const World& world)
{
    for (size_t i = 0; i < world.colliderGrids.size(); ++i) {
        const ColliderGrid& grid = world.colliderGrids[i];
        require(grid.counts.x() >= 2 && grid.counts.z() >= 2 && grid.counts.y() >= 1 &&
                    grid.values.size() == grid.counts.cast<size_t>().prod() && grid.values.size() <= MAX_GRID_VALUES,
                "collider grid {}: its counts and values do not fit", i);
        require(grid.low.allFinite() && grid.cell.allFinite() && grid.cell.minCoeff() > 0.0f,
                "collider grid {}: its place or cells are not finite", i);
        for (const float value : grid.values)
            require(std::isfinite(value), "collider grid {}: a value is not finite", i);
    }
}

}  // namespace

void validate(const World& world)
{
    require(world.particleRadius > 0.0f && std::isfinite(world.particleRadius), "particle radius {} m: must be above 0",
            world.particleRadius);
    requireInput(!world.particles.empty(), "the world has no particles: add an object");
    validateSettings(world.settings);
    require(world.settings.solver == SolverKind::Impulse || !world.shown.contactForces,
            "the paper's solver has no forces of contacts to show");
    validateMaterials(world);
    validateParticles(world);
    validateFluids(world);
    validateEmitters(world);
    validateLinks(world);
    validateJoints(world);
    validateGears(world);
    validateAnimations(world);
    validatePuppets(world);
    validateReleases(world);
    validateColliders(world);
    validateColliderMotions(world);
    validateForces(world);
    validateSoftBodies(world);
    validateStrands(world);
    validateGrids(world);
    validateSkins(world);
    validateBodyShapes(world);
    validateDrawnMatter(world);
    for (const ParticleRange& range : world.unseen)
        require(range.first <= range.end && range.end <= world.particles.size(),
                "unseen particles {} to {}: there are not so many", range.first, range.end);
}

}  // namespace knuckle
