#pragma once

#include "shared/frame_types.h"
#include "sim/gpu/kernel.h"

namespace knuckle {

/// Computes the frame's view on the device, since only the device knows where particles are.
class ViewPasses {
public:
    /// Adds "view" to the table, which must have "frame", "positions", "bodyCentres", "cameraPlanes" and, if particles
    /// are unseen or framed, "unseenParticles" or "framedParticles"; with solids "colliderPlaces", "cameraSolids" and
    /// "cameraGrids".
    ViewPasses(const Gpu& gpu, BufferTable& table, bool hasUnseen, bool hasFramed, bool hasSolids);
    ViewPasses(const ViewPasses&) = delete;
    ViewPasses& operator=(const ViewPasses&) = delete;

    /// Aims the camera.
    void aim(KernelTimer& timer) const;
    /// Fits the shadow map and the burial grid to the scene's contents.
    void fit(KernelTimer& timer) const;
    /// Waits until it is computed.
    gpu::FrameView read() const { return view_.download()[0]; }

private:
    Buffer<gpu::FrameView> view_{"view", 1};
    Buffer<gpu::ParticleBounds> boxes_{"particleBoxes", BOUNDS_THREADS};
    Kernel bounds_, camera_, fit_;
};

}  // namespace knuckle
