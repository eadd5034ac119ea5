#include "app/scene/matter/scene_emitters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/json/fields.h"
#include "app/scene/scene_limits.h"
#include "app/scene/scene_materials.h"
#include "app/scene/scene_places.h"
#include "sim/world/collider_distance.h"
#include "sim/world/space/cells.h"

namespace knuckle {

namespace {

/// One entry of `emitters`.
struct Entry : SceneEntry {
    Emitter emitter = {};
};

/// A description of the object to which a particle belongs.
std::string objectOf(const WorldBuilder& builder, uint32_t particle)
{
    const World& world = builder.world();
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        const std::vector<uint32_t> own = builder.ownParticles(b);
        if (std::find(own.begin(), own.end(), particle) == own.end()) continue;
        return fmt::format("\"{}\"", world.objects[world.bodies[b].object].name);
    }
    return "an object";
}

/// Everything in the scene before fluid flows in.
class Surroundings {
public:
    explicit Surroundings(const SceneContext& context) : context_(context), solids_(context.builder.diameter())
    {
        const std::vector<Particle>& particles = world().particles;
        for (uint32_t i = 0; i < particles.size(); ++i) solids_.add(particles[i].position, i);
    }

    /// Names what a fluid particle at x would overlap; nothing if it has room.
    std::optional<std::string> whatIsAt(const Vector3f& x) const
    {
        for (size_t c = 0; c < world().colliders.size(); ++c)
            if (colliderDistance(world(), world().colliders[c], x) < 0.45f * world().fluidSpacing)
                return context_.colliderEntries[c];
        const std::optional<uint32_t> particle = solids_.anyNear(world().particles, x, fluidClearance(world()));
        if (particle) return objectOf(context_.builder, *particle);
        return std::nullopt;
    }

private:
    const World& world() const { return context_.builder.world(); }

    const SceneContext& context_;
    Cells solids_;
};

void readNozzle(Entry& entry)
{
    const Json& json = entry.json;
    const float spacing = entry.context.builder.fluidSpacing();
    Vector3f position, direction;
    readValue(json["position"], position);
    readValue(json["direction"], direction);
    if (direction.norm() < 1e-6f) entry.fail("/direction", "must not be zero");
    direction.normalize();
    const bool disc = json["shape"] == "disc";
    Nozzle nozzle = disc ? discNozzle(json["radius"], spacing)
                         : rectangleNozzle(json["size"][0], json["size"][1], spacing);
    if (nozzle.points.empty())
        entry.fail(disc ? "/radius" : "/size",
                   fmt::format("a particle takes {:g} m, which is too wide for it; make it larger, or lower "
                               "/fluidSpacing or /diameter",
                               spacing));
    const auto layer = static_cast<double>(nozzle.points.size());
    limitTotal(entry, "", layer, "make the nozzle smaller");
    entry.emitter.nozzle = placed(std::move(nozzle), position, direction);
    const float speed = json["speed"], most = entry.context.builder.world().settings.maxSpeed;
    if (speed > most)
        entry.fail("/speed", fmt::format("{:g} m/s is above /solver/maxSpeed, {:g} m/s; lower it or raise the other",
                                         speed, most));
    entry.emitter.velocity = speed * direction;
}

void readTimesAndPool(Entry& entry)
{
    const Json& json = entry.json;
    Emitter& emitter = entry.emitter;
    emitter.start = json["start"];
    emitter.stop = json["stop"];
    if (emitter.stop < emitter.start)
        entry.fail("/stop", fmt::format("{:g} s is before start, {:g} s; raise it or lower the other", emitter.stop,
                                        emitter.start));
    emitter.takesOldest = json["whenEmpty"] == "oldest";
    const auto layer = static_cast<double>(emitter.nozzle.points.size());
    const double given = json["pool"];
    if (given > 0.0 && given < layer)
        entry.fail("/pool", fmt::format("{:g} particles are fewer than the {:g} of a layer; raise it, or make the "
                                        "nozzle smaller",
                                        given, layer));
    const double all = layer * static_cast<double>(std::max<uint64_t>(emitter.layersUntil(entry.context.duration), 1));
    const double pool = given > 0.0 ? given : all;
    limitTotal(entry, "/pool", pool, "give a smaller pool, with drains or with whenEmpty \"oldest\"");
    emitter.pool = static_cast<uint32_t>(pool);
}

/// Refuses a nozzle that is blocked, or whose jet would be blocked within its first step.
void requireRoom(const Entry& entry, const Surroundings& surroundings)
{
    const World& world = entry.context.builder.world();
    const float spacing = world.fluidSpacing, speed = entry.emitter.velocity.norm();
    const Vector3f direction = entry.emitter.velocity / speed;
    const float ahead = std::max(spacing, speed * world.settings.timeStep);
    const int steps = static_cast<int>(std::ceil(2.0f * ahead / spacing));
    for (int k = 0; k <= steps; ++k) {
        const float way = ahead * static_cast<float>(k) / static_cast<float>(steps);
        for (const Vector3f& point : entry.emitter.nozzle.points) {
            const std::optional<std::string> solid = surroundings.whatIsAt(point + way * direction);
            if (!solid) continue;
            if (k == 0)
                entry.fail("/position", fmt::format("the nozzle is inside or against {}; keep it at least half a rest "
                                                    "distance, {:g} m, away",
                                                    *solid, 0.5f * spacing));
            entry.fail("/direction", fmt::format("leads into {} within {:.3g} m; turn it away, or move the nozzle back",
                                                 *solid, way));
        }
    }
}

void requireNoDrain(const Entry& entry)
{
    const World& world = entry.context.builder.world();
    for (size_t d = 0; d < world.drains.size(); ++d)
        for (const Vector3f& point : entry.emitter.nozzle.points)
            if (regionDistance(world.drains[d], point) < 0.0f)
                entry.fail("/position", fmt::format("the nozzle is inside /drains/{}; move one of them", d));
}

}  // namespace

void addEmitters(SceneContext& context, const Json& root)
{
    for (const Json& drain : root["drains"]) context.builder.addDrain(readRegion(drain));
    if (root["emitters"].empty()) return;
    const Surroundings surroundings(context);
    for (size_t i = 0; i < root["emitters"].size(); ++i) {
        Entry entry{{context, root["emitters"][i], fmt::format("/emitters/{}", i)}};
        entry.emitter.material = findMaterial(context, entry.json["material"], entry.pointer + "/material");
        requireFluid(context, entry.emitter.material, entry.pointer + "/material");
        readNozzle(entry);
        readTimesAndPool(entry);
        requireRoom(entry, surroundings);
        requireNoDrain(entry);
        context.builder.addEmitter(std::move(entry.emitter));
    }
}

}  // namespace knuckle
