#pragma once

#include "render/settings.h"
#include "shared/gpu_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/buffer_table.h"
#include "sim/world/world.h"

namespace knuckle {

/// Whether any fluid of a world is drawn in that way (FluidLook). Where particles have colours of their own, all are
/// drawn as particles.
bool drawsFluids(const World& world, const RenderSettings& settings, DrawnAs as);

/// Whether any fluid that is drawn as a surface sends out light.
bool fluidsEmit(const World& world, const RenderSettings& settings);

/// How fluids look, on the device: "fluidLooks" and "fluidMaterials".
class FluidLooks {
public:
    /// Adds its buffers to the table.
    FluidLooks(BufferTable& table, const World& world, const RenderSettings& settings);
    FluidLooks(const FluidLooks&) = delete;
    FluidLooks& operator=(const FluidLooks&) = delete;

private:
    Buffer<gpu::vec4> looks_;
    Buffer<uint32_t> materials_;
};

}  // namespace knuckle
