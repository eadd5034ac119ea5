#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Matter other than rigid bodies: grains, soft bodies, and the distances of ropes and cloth.
class LooseBuilder : public virtual WorldDraft {
public:
    /// A particle without a body: a grain. @returns its index.
    uint32_t addLooseParticle(const Particle& particle);
    /// A soft body of particles at `positions` (rest pose of the object) [m], with the elasticity of its material.
    /// @param pinned indices into `positions`: these particles stay in place.
    /// @returns the soft body's index. @throws std::logic_error for an empty span or a position that is not finite.
    uint32_t addSoftBody(std::string name, std::span<const Vector3f> positions, uint32_t material,
                         std::span<const uint32_t> pinned = {});
    /// Names particles from `first` up to now as one object's, for World::looseGroups.
    void nameLoose(std::string name, uint32_t first);
    /// Distances between particles that exist: see addRope() and addCloth().
    void addStrand(Strand row);
    /// What is drawn of matter that exists otherwise than as spheres (World::drawn).
    void drawCloth(ClothSurface sheet) { world_.drawn.cloth.push_back(std::move(sheet)); }
    /// Draws the strand that was added last as a tube.
    void drawRope() { world_.drawn.ropes.push_back(static_cast<uint32_t>(world_.strands.size() - 1)); }
    void drawSoft(SoftSurface surface) { world_.drawn.soft.push_back(std::move(surface)); }
    /// Draws the loose particles from `first` up to now as grains.
    void drawGrains(uint32_t first) { world_.drawn.grains.push_back({first, particleCount()}); }
    /// A triangle of cloth, for the air. @param corners particles.
    void addClothTriangle(const std::array<uint32_t, 3>& corners) { world_.clothTriangles.push_back(corners); }
};

}  // namespace knuckle
