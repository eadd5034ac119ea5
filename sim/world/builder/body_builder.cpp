#include "sim/world/builder/body_builder.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace knuckle {

void BodyBuilder::addSkin(const std::shared_ptr<const SkinMesh>& mesh, std::span<const uint32_t> objects, SkinUse use)
{
    const auto same = [&](const Skin& skin) { return skin.mesh == mesh && skin.use == use; };
    auto skin = std::ranges::find_if(world_.skins, same);
    if (skin == world_.skins.end()) skin = world_.skins.insert(skin, {mesh, {}, use});
    skin->objects.insert(skin->objects.end(), objects.begin(), objects.end());
}

void BodyBuilder::drawShape(uint32_t body, BodyShape shape)
{
    shape.body = body;
    world_.bodyShapes.push_back(shape);
}

void BodyBuilder::beginObject(std::string name)
{
    if (objectOpen_) throw std::logic_error(fmt::format("object \"{}\": the one before is still open", name));
    objectOpen_ = true;
    objectFirstParticle_ = particleCount();
    Object object;
    object.name = std::move(name);
    object.bodyStart = static_cast<uint32_t>(world_.bodies.size());
    world_.objects.push_back(std::move(object));
}

uint32_t BodyBuilder::addBody(std::string name, std::span<const Vector3f> positions, uint32_t material, Motion motion,
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

void BodyBuilder::holdBody(uint32_t body, float releaseTime)
{
    world_.bodies.at(body).motion = Motion::Fixed;
    world_.bodies[body].releaseTime = releaseTime;
}

void BodyBuilder::throwBody(uint32_t body, const Vector3f& velocity, const Vector3f& spin, bool appears)
{
    world_.bodies.at(body).throwVelocity = velocity;
    world_.bodies[body].throwSpin = spin;
    world_.bodies[body].absent = appears;
}

void BodyBuilder::setSelfMargin(float margin)
{
    requireObject("setSelfMargin");
    for (uint32_t i = objectFirstParticle_; i < particleCount(); ++i) world_.particles[i].selfMargin = margin;
}

void BodyBuilder::markCross(uint32_t body)
{
    for (uint32_t particle : bodyParticles_.at(body)) world_.particles[particle].touchesAssembly = false;
    world_.bodies[body].isCross = true;
}

void BodyBuilder::filterPair(uint32_t body, uint32_t other)
{
    const auto add = [&](uint32_t a, uint32_t b) {
        std::vector<uint32_t>& filtered = world_.bodies.at(a).filtered;
        if (std::ranges::find(filtered, b) == filtered.end()) filtered.push_back(b);
    };
    add(body, other);
    add(other, body);
}

uint32_t BodyBuilder::endObject(const Pose& pose, const Vector3f& velocity, const Vector3f& spin)
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

std::vector<uint32_t> BodyBuilder::ownParticles(uint32_t body) const
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
