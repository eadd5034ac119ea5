#pragma once

#include "render/draw_pass.h"
#include "shared/draw_types.h"
#include "sim/gpu/kernel.h"
#include "sim/world/world.h"

namespace knuckle {

/// Spheres that are listed separately.
enum class SphereGroup : uint32_t { Solid = SOLID_SPHERES, Fluid = FLUID_SPHERES };

/// Lists, on the device, which particles the camera and the key light can see. Buried particles, and those that skins
/// cover, are in neither list.
class SphereLists {
public:
    /// Adds "sphereList", "sphereScales" and its own buffers to the table, which must have "frame", "view" and
    /// "positions". @param seesThrough  Whether things are seen through fluids, which then bury nothing.
    SphereLists(const Gpu& gpu, BufferTable& table, const World& world, bool seesThrough);
    SphereLists(const SphereLists&) = delete;
    SphereLists& operator=(const SphereLists&) = delete;

    void update(KernelTimer& timer);
    /// Draws points (POINT_DRAW), corners (QUAD_DRAW) or points in the light's view (SHADOW_DRAW) of a group.
    void draw(KernelTimer& timer, const DrawPass& pass, SphereGroup group, uint32_t kind) const;

private:
    uint32_t particleCount_;
    Buffer<uint32_t> covered_;  ///< A bit per particle.
    Buffer<float> scales_;      ///< Per particle: Particle::scale.
    Buffer<uint32_t> drawKinds_, list_, cells_, buried_;
    Buffer<gpu::uvec4> counts_;
    Buffer<gpu::DrawArguments> draws_;
    Kernel burialCount_, burialCells_, burialHidden_, cull_, offsets_, write_;
};

}  // namespace knuckle
