#pragma once

#include "render/settings.h"
#include "shared/frame_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/gpu.h"
#include "sim/gpu/program.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// Draws the particles as spheres, from the solver's own buffers.
class SpherePass {
public:
    SpherePass(const Gpu& gpu, const World& world, const RenderSettings& settings);
    ~SpherePass();
    SpherePass(const SpherePass&) = delete;
    SpherePass& operator=(const SpherePass&) = delete;

    /// Binds the view's buffers where shaders expect them. Call once a frame, before the others.
    void attach(const ParticleView& view);
    /// Lists what the camera and the key light can see. Buried particles are in neither list.
    void list();
    /// Into the bound shadow map.
    void drawShadow() const;
    /// Into the bound geometry buffers.
    void draw() const;
    /// gl_PointSize beyond which spheres are drawn as quads [pixels].
    float pointSizeLimit() const { return pointSizeLimit_; }

private:
    void bindAttributes(GLuint positions);
    void findBuried();

    Program burialCount_, burialCells_, burialHidden_, cull_, offsets_, list_, points_, quads_, shadow_;
    Buffer<uint32_t> colors_, visible_, counts_, indices_, cells_, buried_;
    Buffer<gpu::DrawArguments> draws_;
    GLuint pointArray_ = 0, quadArray_ = 0, positionTexture_ = 0, velocityTexture_ = 0;
    ParticleView attached_;
    float pointSizeLimit_ = 1.0f;
};

}  // namespace knuckle
