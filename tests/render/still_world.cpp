#include "tests/render/still_world.h"

#include <cmath>
#include <stdexcept>

#include "sim/solver/pack.h"

namespace knuckle::test {

namespace {

template <typename T, typename Make>
Buffer<gpu::vec4> vectors(const char* label, const std::vector<T>& items, Make make)
{
    std::vector<gpu::vec4> out;
    for (const T& item : items) {
        const Vector3f v = make(item);
        out.push_back({v.x(), v.y(), v.z(), 0.0f});
    }
    return {label, out};
}

/// The last ones are inactive: those in the pools of emitters.
Buffer<gpu::vec4> positionsOf(const World& world)
{
    std::vector<gpu::vec4> out;
    const size_t there = world.particles.size() - world.pooledCount();
    for (const Particle& p : world.particles)
        out.push_back({p.position.x(), p.position.y(), p.position.z(), out.size() < there ? 0.0f : 1.0f});
    return {"positions", out};
}

Buffer<gpu::vec4> rotationsOf(const World& world)
{
    std::vector<gpu::vec4> out;
    for (const Body& body : world.bodies) out.push_back(pack(body.rotation));
    return {"rotations", out};
}

Buffer<gpu::vec4> placesOf(const World& world)
{
    std::vector<gpu::vec4> out;
    for (const Collider& collider : world.colliders) {
        out.push_back(pack(collider.position, 0));
        out.push_back(pack(collider.orientation));
    }
    return {"places", out};
}

}  // namespace

StillWorld::StillWorld(float radius)
{
    world.particleRadius = radius;
    world.materials = {{.name = "clay", .color = {0.72f, 0.33f, 0.20f}},
                       {.name = "stone", .color = {0.5f, 0.5f, 0.45f}}};
}

uint32_t StillWorld::addBody(const std::vector<Vector3f>& offsets, const Vector3f& position,
                             const Quaternionf& rotation, const Vector3f& velocity)
{
    const auto index = static_cast<uint32_t>(world.bodies.size());
    Body body;
    body.name = "body " + std::to_string(index);
    body.material = index % 2;
    body.assembly = body.object = index;
    body.linkStart = static_cast<uint32_t>(world.links.size());
    body.linkCount = static_cast<uint32_t>(offsets.size());
    body.position = position;
    body.rotation = rotation;
    world.objects.push_back({body.name, index, 1});
    world.bodies.push_back(body);
    for (const Vector3f& offset : offsets) {
        Particle particle;
        particle.position = position + rotation * offset;
        particle.velocity = velocity;
        particle.material = body.material;
        particle.body = particle.assembly = index;
        particle.bodyCount = 1;
        world.links.push_back({static_cast<uint32_t>(world.particles.size()), index, offset, 1.0f});
        world.particles.push_back(particle);
    }
    return index;
}

void StillWorld::addGround()
{
    addCollider(ColliderShape::Plane, Vector3f::Zero());
}

Collider& StillWorld::addCollider(ColliderShape shape, const Vector3f& position)
{
    Collider collider;
    collider.shape = shape;
    collider.position = position;
    return world.colliders.emplace_back(collider);
}

StillBuffers::StillBuffers(const World& world, const std::vector<uint32_t>& forms)
    : radius_(world.particleRadius), fluidSpacing_(world.fluidSpacing), solidCount_(world.solidCount()),
      positions_(positionsOf(world)),
      velocities_(vectors("velocities", world.particles, [](const Particle& p) { return p.velocity; })),
      centres_(vectors("centres", world.bodies, [](const Body& b) { return b.position; })),
      rotations_(rotationsOf(world)), places_(placesOf(world)), forms_("forms", std::span<const uint32_t>(forms))
{
}

ParticleView StillBuffers::view() const
{
    ParticleView view{positions_.id(),
                      velocities_.id(),
                      centres_.id(),
                      rotations_.id(),
                      places_.id(),
                      static_cast<uint32_t>(positions_.size()),
                      static_cast<uint32_t>(centres_.size()),
                      static_cast<uint32_t>(places_.size() / 2),
                      radius_,
                      solidCount_,
                      fluidSpacing_};
    if (forms_.size() > 0) view.fluidForms = forms_.id();
    return view;
}

uint32_t packedForm(const Vector3f& axis, double along, double across)
{
    const auto steps = [](double length) {
        return static_cast<uint32_t>(std::lround(64 + 63 * std::log2(length) / 0.9));
    };
    const Vector3f p = axis / axis.cwiseAbs().sum();
    if (p.z() < 0.0f) throw std::logic_error("an axis is the same both ways: z at least 0");
    const auto square = [](float x) { return static_cast<uint32_t>(std::lround((0.5f + 0.5f * x) * 511.0f)); };
    return square(p.x()) | square(p.y()) << 9 | steps(along) << 18 | steps(across) << 25;
}

void addFluid(World& world, const std::vector<Vector3f>& positions)
{
    for (const Vector3f& position : positions) {
        Particle particle;
        particle.position = position;
        world.particles.push_back(particle);
        ++world.fluidCount;
    }
}

std::vector<Vector3f> cubeLattice(int count, float diameter)
{
    std::vector<Vector3f> points;
    const float middle = 0.5f * static_cast<float>(count - 1);
    for (int z = 0; z < count; ++z)
        for (int y = 0; y < count; ++y)
            for (int x = 0; x < count; ++x)
                points.push_back(diameter * (Vector3f(float(x), float(y), float(z)).array() - middle).matrix());
    return points;
}

}  // namespace knuckle::test
