#include "sim/world/builder/builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/world/builder/joints.h"

namespace knuckle {

WorldBuilder::WorldBuilder(float particleRadius, const Settings& settings)
{
    if (!(particleRadius > 0.0f) || !std::isfinite(particleRadius))  // before anything is divided by it
        throw std::logic_error(fmt::format("particle radius {} m: must be above 0", particleRadius));
    world_.particleRadius = particleRadius;
    world_.settings = settings;
    setFluidSpacing(0.5f);
    choosesSubsteps_ = settings.substeps == 0;
    if (choosesSubsteps_)
        world_.settings.substeps = automaticSubsteps(world_.diameter(), settings.timeStep, settings.solver);
}

uint32_t WorldBuilder::addMaterial(Material material)
{
    world_.materials.push_back(std::move(material));
    return static_cast<uint32_t>(world_.materials.size() - 1);
}

void WorldBuilder::addCollider(const Collider& collider)
{
    world_.colliders.push_back(collider);
}

uint32_t WorldBuilder::addColliderGrid(ColliderGrid grid)
{
    world_.colliderGrids.push_back(std::move(grid));
    return static_cast<uint32_t>(world_.colliderGrids.size() - 1);
}

void WorldBuilder::addSkin(const std::shared_ptr<const SkinMesh>& mesh, std::span<const uint32_t> objects, SkinUse use)
{
    const auto same = [&](const Skin& skin) { return skin.mesh == mesh && skin.use == use; };
    auto skin = std::ranges::find_if(world_.skins, same);
    if (skin == world_.skins.end()) skin = world_.skins.insert(skin, {mesh, {}, use});
    skin->objects.insert(skin->objects.end(), objects.begin(), objects.end());
}

void WorldBuilder::requireObject(const char* what) const
{
    if (!objectOpen_) throw std::logic_error(fmt::format("{}: call beginObject() first", what));
}

void WorldBuilder::beginObject(std::string name)
{
    if (objectOpen_) throw std::logic_error(fmt::format("object \"{}\": the one before is still open", name));
    objectOpen_ = true;
    objectFirstParticle_ = particleCount();
    Object object;
    object.name = std::move(name);
    object.bodyStart = static_cast<uint32_t>(world_.bodies.size());
    world_.objects.push_back(std::move(object));
}

uint32_t WorldBuilder::newParticle(const Vector3f& position, uint32_t material)
{
    Particle particle;
    particle.position = particle.restPosition = position;
    particle.material = material;
    particle.mass = particleMass(material);
    world_.particles.push_back(particle);
    return particleCount() - 1;
}

float WorldBuilder::particleMass(uint32_t material) const
{
    return world_.materials.at(material).density * std::pow(world_.diameter(), 3.0f);
}

std::vector<uint32_t> WorldBuilder::newParticles(const std::string& name, std::span<const Vector3f> positions,
                                                 uint32_t material)
{
    if (material >= world_.materials.size())
        throw std::logic_error(fmt::format("body \"{}\": there is no material {}", name, material));
    if (positions.empty()) throw std::logic_error(fmt::format("body \"{}\" has no particles", name));
    std::vector<uint32_t> indices;
    for (const Vector3f& position : positions) {
        if (!position.allFinite())
            throw std::logic_error(fmt::format("body \"{}\": a particle's position is not finite", name));
        indices.push_back(newParticle(position, material));
    }
    return indices;
}

uint32_t WorldBuilder::addBody(std::string name, std::span<const Vector3f> positions, uint32_t material, Motion motion,
                               std::span<const SurfaceDistance> surface, const RoundShape& round)
{
    requireObject("addBody");
    Body body;
    body.name = std::move(name);
    body.motion = motion;
    body.material = material;
    body.object = static_cast<uint32_t>(world_.objects.size() - 1);
    const auto index = static_cast<uint32_t>(world_.bodies.size());
    bodyParticles_.push_back(newParticles(body.name, positions, material));
    const std::vector<SurfaceDistance> lattice = surface.empty() ? latticeSurface(positions, world_.diameter())
                                                                 : std::vector<SurfaceDistance>();
    if (surface.empty()) surface = lattice;
    for (size_t i = 0; i < std::min(positions.size(), surface.size()); ++i)
        world_.particles[bodyParticles_[index][i]].surface = surface[i];
    if (world_.settings.solver == SolverKind::Impulse) body.round = round;
    Object& object = world_.objects.back();
    ++object.bodyCount;
    world_.bodies.push_back(std::move(body));
    return index;
}

void WorldBuilder::holdBody(uint32_t body, float releaseTime)
{
    world_.bodies.at(body).motion = Motion::Fixed;
    world_.bodies[body].releaseTime = releaseTime;
}

void WorldBuilder::shareParticle(uint32_t particle, uint32_t body)
{
    auto& members = bodyParticles_.at(body);
    if (std::find(members.begin(), members.end(), particle) == members.end()) members.push_back(particle);
}

uint32_t WorldBuilder::findOrCreate(const Vector3f& position, uint32_t bodyA, uint32_t bodyB)
{
    // Just under half a diameter: a place midway between two lattice points gets a particle of its own.
    float nearest = 0.49f * world_.diameter();
    uint32_t found = NO_INDEX;
    for (uint32_t body : {bodyA, bodyB})
        for (uint32_t particle : bodyParticles_[body]) {
            const float distance = (world_.particles[particle].position - position).norm();
            if (distance < nearest) {
                nearest = distance;
                found = particle;
            }
        }
    return found != NO_INDEX ? found : newParticle(position, world_.bodies[bodyA].material);
}

void WorldBuilder::shareAt(std::span<const Vector3f> places, uint32_t bodyA, uint32_t bodyB)
{
    for (const Vector3f& place : places) {
        const uint32_t particle = findOrCreate(place, bodyA, bodyB);
        shareParticle(particle, bodyA);
        shareParticle(particle, bodyB);
    }
}

void WorldBuilder::addJoint(uint32_t parent, uint32_t child, const JointSpec& spec)
{
    requireObject("addJoint");
    if (parent == child || std::max(parent, child) >= world_.bodies.size())
        throw std::logic_error(fmt::format("joint \"{}\": needs two different bodies that exist", spec.name));
    if (spec.type == JointType::Universal) return addUniversal(parent, child, spec);
    const JointPlaces places = jointPlaces(spec, world_.diameter());
    shareAt(places.shared, parent, child);
    for (const Vector3f& place : places.limits)
        shareParticle(newParticle(place, world_.bodies[parent].material), parent);
    JointDraft draft{{spec.name, spec.type, parent, child}};
    draft.joint.strength = spec.strength;
    setLimits(draft, spec.limits, spec.type == JointType::Ball ? alongOf(spec) : spec.axis.normalized());
    describeJoint(std::move(draft));
}

void WorldBuilder::addUniversal(uint32_t parent, uint32_t child, const JointSpec& spec)
{
    const JointPlaces places = jointPlaces(spec, world_.diameter());
    const uint32_t cross = addBody(spec.name + ".cross", places.middle, world_.bodies[parent].material);
    // Where the axes cross, all three bodies share a particle: it carries the load, the light cross only the twist.
    shareAt(places.middle, parent, cross);
    shareParticle(bodyParticles_[cross].front(), child);
    shareAt(places.sharedWithParent, parent, cross);
    shareAt(places.sharedWithChild, child, cross);
    markCross(cross);
    JointDraft first{{spec.name + ".cross", JointType::Hinge, parent, cross}};
    JointDraft second{{spec.name, JointType::Hinge, cross, child}};
    first.joint.strength = second.joint.strength = spec.strength;
    const Vector3f axis = spec.axis.normalized();
    JointLimits secondLimits = spec.limits;
    secondLimits.bend = spec.limits.secondBend;
    setLimits(first, spec.limits, axis);
    setLimits(second, secondLimits, alongOf(spec).cross(axis));
    describeJoint(std::move(first));
    describeJoint(std::move(second));
}

void WorldBuilder::describeJoint(JointDraft draft)
{
    requireObject("describeJoint");
    joints_.push_back(std::move(draft));
}

void WorldBuilder::setSelfMargin(float margin)
{
    requireObject("setSelfMargin");
    for (uint32_t i = objectFirstParticle_; i < particleCount(); ++i) world_.particles[i].selfMargin = margin;
}

void WorldBuilder::markCross(uint32_t body)
{
    for (uint32_t particle : bodyParticles_.at(body)) world_.particles[particle].touchesAssembly = false;
    world_.bodies[body].isCross = true;
}

void WorldBuilder::passThrough(uint32_t body, uint32_t other)
{
    const auto add = [&](uint32_t a, uint32_t b) {
        std::vector<uint32_t>& passes = world_.bodies.at(a).passes;
        if (std::ranges::find(passes, b) == passes.end()) passes.push_back(b);
    };
    add(body, other);
    add(other, body);
}

uint32_t WorldBuilder::endObject(const Pose& pose, const Vector3f& velocity, const Vector3f& spin)
{
    requireObject("endObject");
    objectOpen_ = false;
    Vector3f weighted = Vector3f::Zero();
    float mass = 0.0f;
    for (uint32_t i = objectFirstParticle_; i < particleCount(); ++i) {
        weighted += world_.particles[i].mass * world_.particles[i].position;
        mass += world_.particles[i].mass;
    }
    const Vector3f centre = pose.apply(mass > 0.0f ? Vector3f(weighted / mass) : Vector3f::Zero());
    for (uint32_t i = objectFirstParticle_; i < particleCount(); ++i) {
        Particle& particle = world_.particles[i];
        particle.position = pose.apply(particle.position);
        particle.velocity = velocity + spin.cross(particle.position - centre);
    }
    const Object& object = world_.objects.back();
    for (uint32_t b = object.bodyStart; b < object.bodyStart + object.bodyCount; ++b) {
        world_.bodies[b].rotation = pose.rotation;
        world_.bodies[b].position = pose.translation;  // moved to the body's centre by build()
    }
    for (SoftBody& soft : world_.softBodies)
        if (soft.object + 1 == world_.objects.size()) soft.rotation = pose.rotation;
    return static_cast<uint32_t>(world_.objects.size() - 1);
}

uint32_t WorldBuilder::addLooseParticle(const Particle& particle)
{
    world_.particles.push_back(particle);
    return particleCount() - 1;
}

void WorldBuilder::setFluidSpacing(float spacing)
{
    world_.fluidSpacing = spacing * world_.diameter();
}

void WorldBuilder::addStrand(Strand row)
{
    world_.strands.push_back(std::move(row));
}

std::vector<uint32_t> WorldBuilder::ownParticles(uint32_t body) const
{
    std::vector<uint32_t> own = bodyParticles_.at(body);
    std::vector<uint32_t> others;
    for (uint32_t b = 0; b < bodyParticles_.size(); ++b)
        if (b != body) others.insert(others.end(), bodyParticles_[b].begin(), bodyParticles_[b].end());
    std::sort(others.begin(), others.end());
    std::erase_if(own, [&](uint32_t particle) { return std::binary_search(others.begin(), others.end(), particle); });
    return own;
}

}  // namespace knuckle
