#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// A World under construction, which the builders of all kinds of matter share.
class WorldDraft {
public:
    uint32_t addMaterial(Material material);
    const Material& material(uint32_t index) const { return world_.materials.at(index); }
    uint32_t particleCount() const { return static_cast<uint32_t>(world_.particles.size()); }
    float diameter() const { return world_.diameter(); }
    /// The mass of a particle of a material: density times diameter cubed [kg].
    float particleMass(uint32_t material) const;
    /// Particles that are not drawn (World::unseen): from `first` to before `end`.
    void hideParticles(uint32_t first, uint32_t end) { world_.unseen.push_back({first, end}); }
    /// The world built so far: particles are placed; links and assemblies do not exist before build().
    const World& world() const { return world_; }

protected:
    WorldDraft() = default;  // never used for a built draft: WorldBuilder passes the arguments
    WorldDraft(float particleRadius, const Settings& settings);
    ~WorldDraft() = default;
    WorldDraft(WorldDraft&&) = default;

    uint32_t newParticle(const Vector3f& position, uint32_t material);
    /// As newParticle for each. @throws std::logic_error for input that addBody() and addSoftBody() refuse.
    std::vector<uint32_t> newParticles(const std::string& name, std::span<const Vector3f> positions, uint32_t material);
    void requireObject(const char* what) const;

    World world_;
    std::vector<std::vector<uint32_t>> bodyParticles_;  ///< Per body, the particles in its block, in order.
    std::vector<std::vector<uint32_t>> owners_;         ///< Per particle, its bodies.
    /// By body and particle: where particles of joints across objects are in the body's rest pose [m].
    std::map<std::pair<uint32_t, uint32_t>, Vector3f> foreignPlaces_;
    std::vector<JointDraft> joints_;
    std::vector<GearDraft> gears_;
    bool choosesSubsteps_ = false;         ///< Settings::substeps was 0.
    std::vector<LooseGroup> fluidGroups_;  // ranges of the next
    std::vector<Particle> fluid_;
    bool objectOpen_ = false;
    uint32_t objectFirstParticle_ = 0;
};

}  // namespace knuckle
