#pragma once

#include <optional>
#include <vector>

#include "render/colliders/collider_pass.h"
#include "render/fluids/fluid_looks.h"
#include "render/fluids/fluid_pass.h"
#include "render/layers/layer_passes.h"
#include "render/looks/picture_looks.h"
#include "render/marks/mark_pass.h"
#include "render/panes/pane.h"
#include "render/picture/lens_passes.h"
#include "render/picture/picture_passes.h"
#include "render/picture/picture_reader.h"
#include "render/quantities/quantity_pass.h"
#include "render/ropes/rope_pass.h"
#include "render/shapes/shape_pass.h"
#include "render/shown_buffers.h"
#include "render/skins/skin_pass.h"
#include "render/spheres/sphere_pass.h"
#include "render/surfaces/surface_pass.h"
#include "render/view/camera_obstacles.h"
#include "render/view/framed_sets.h"
#include "render/view/view_passes.h"

namespace knuckle {

/// Members are in the order of their dependencies: each pass finds its inputs in the table when it is made.
struct Pane::Impl {
    Impl(Gpu& gpu, const World& world, const RenderSettings& chosen, KernelTimer& timerIn);
    BufferTable& addInputs();  ///< Adds to the table, which it returns.
    void attach(const ParticleView& drawn);
    /// @param time of the film [s]. @param draw of a frame.
    void aimCamera(double time, uint32_t draw);
    /// Draws of a frame, with the same view: from `first` on, as many.
    void expose(double time, uint32_t first, uint32_t count);
    /// Draws what casts shadows and what is visible, with the light that reaches it.
    void drawSurfaces(bool withSkins, bool withParticles);
    /// Only what is visible, into the geometry buffers.
    void drawGeometry(bool withSkins, bool withParticles);
    /// Over the lit picture: what mirrors or is seen through, on one side of the surface of fluids.
    void drawOver(FluidSide side);
    void drawOnce();
    /// Places vertices for layers, and draws these if they are wanted. With the vertices' places of the frame before.
    void drawLayers(const ParticleView& drawn, double time, bool wanted);
    /// At the depth of what the camera aims at; waits for the frame.
    float pixelsPerMetre() const;

    RenderSettings settings;
    SceneExtent extent;
    std::vector<Shot> shots;
    std::vector<Camera> cameras;  ///< Of the shots.
    FramedSets framed;            ///< Of the same.
    gpu::FrameInput input;
    bool beads;                      ///< Whether fluids are drawn as spheres.
    std::optional<double> lookedAt;  ///< Time of the film at the camera's last look [s].
    Buffer<gpu::FrameInput> inputBuffer{"frame", 1};
    Buffer<uint32_t> unseen, framedParticles;
    CameraObstacles obstacles;
    ShownBuffers shown;
    RenderTargets targets;
    BufferTable table;
    ViewPasses view;
    QuantityPass quantities;
    FluidLooks fluidLooks;
    PictureLooks looks;
    SphereLists lists;
    ColliderPass colliders;
    SkinPass skins;
    ShapePass shapes;
    SurfacePass surfaces;
    RopePass ropes;
    SpherePass spheres;
    FluidPass fluids;
    PicturePasses picture;
    LensPasses lens;
    MarkPass marks;
    PictureReader reader;
    std::optional<LayerPasses> layers;  ///< None: pictures are drawn.
    KernelTimer& timer;
};

}  // namespace knuckle
