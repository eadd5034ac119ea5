#pragma once

#include "render/colliders/collider_meshes.h"
#include "render/view/camera.h"
#include "shared/frame_types.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/gpu.h"
#include "sim/gpu/program.h"
#include "sim/world/world.h"

namespace knuckle {

/// The visible colliders: planes over the whole picture, grids as triangles, others as ray-cast shapes inside boxes.
class StaticGeometry {
public:
    StaticGeometry(const Gpu& gpu, const World& world, const SceneExtent& extent);
    ~StaticGeometry();
    StaticGeometry(const StaticGeometry&) = delete;
    StaticGeometry& operator=(const StaticGeometry&) = delete;

    /// Into the bound geometry buffers.
    void draw() const;
    /// Into the bound shadow map. Planes cast no shadow.
    void drawShadow() const;

private:
    struct Plane {
        gpu::vec4 equation;     ///< Unit normal, and its component of the plane's points [m].
        gpu::vec4 color;        ///< w: 1 for the ground.
    };
    void drawShapes() const;

    std::vector<Plane> planes_;
    ColliderMeshes meshes_;
    Buffer<gpu::ColliderInstance> shapes_;
    GLuint vertexArray_ = 0;
    Program planeProgram_, shapeProgram_, shadowProgram_;
};

}  // namespace knuckle
