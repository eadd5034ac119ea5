#pragma once

#include <array>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/gpu.h"
#include "sim/gpu/program.h"
#include "sim/world/world.h"

namespace knuckle {

/// The visible colliders that are made of triangles: meshes and heightfields.
class ColliderMeshes {
public:
    ColliderMeshes(const Gpu& gpu, const World& world);
    ~ColliderMeshes();
    ColliderMeshes(const ColliderMeshes&) = delete;
    ColliderMeshes& operator=(const ColliderMeshes&) = delete;

    /// Into the bound geometry buffers.
    void draw() const;
    /// Into the bound shadow map.
    void drawShadow() const;

private:
    /// Triangles of one collider, in a row of the corners.
    struct Part {
        GLint first;
        GLsizei count;
        std::array<float, 3> color;
    };

    std::vector<Part> parts_;
    Buffer<float> corners_;   ///< Place and normal in the world.
    GLuint vertexArray_ = 0;
    Program program_, shadowProgram_;
};

}  // namespace knuckle
