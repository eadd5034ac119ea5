#pragma once

#include <span>

#include "sim/world/builder/world_draft.h"

namespace knuckle {

/// Fluids, emitters and drains.
class FluidBuilder : public virtual WorldDraft {
public:
    /// Adds fluid particles of a fluid material. They come after all others, whenever they are added; build() leaves
    /// out those that overlap other particles. @param name, visible  of the object that they are, for
    /// World::looseGroups and World::unseen.
    void addFluid(std::span<const Vector3f> positions, const Vector3f& velocity, uint32_t material,
                  std::string name = {}, bool visible = true);
    /// Sets the rest distance of fluids [diameters], 0.3 ... 0.6. Must be called before addFluid().
    void setFluidSpacing(float spacing);
    float fluidSpacing() const { return world_.fluidSpacing; }
    /// Its pool comes after all fluids. @throws std::logic_error unless its material is a fluid.
    void addEmitter(Emitter emitter);
    /// A plane, box, sphere or capsule in which fluids vanish.
    void addDrain(const Region& region) { world_.drains.push_back(region); }
    uint32_t fluidCount() const { return static_cast<uint32_t>(fluid_.size()); }

protected:
    /// Adds fluid particles that overlap nothing, and the pools of emitters; chooses the substeps that they need.
    void placeFluid();

private:
    /// Takes away what has no room, and adds the rest to the world's particles and groups.
    void placeFilled();
    void requireFluid(const char* what, uint32_t material) const;
    Particle fluidParticle(uint32_t material) const;
};

}  // namespace knuckle
