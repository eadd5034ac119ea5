#include "render/colliders/static_geometry.h"

#include <cmath>

namespace knuckle {

namespace {

/// Corners of the strip in collider.vert.
constexpr GLsizei BOX_STRIP = 14;
constexpr GLuint INSTANCE_VECTORS = sizeof(gpu::ColliderInstance) / sizeof(gpu::vec4);

gpu::ColliderInstance instanceOf(const Collider& collider)
{
    Vector3f half = collider.halfExtents;
    float radius = 0.0f;
    if (collider.shape != ColliderShape::Box) {
        radius = collider.radius;
        const float straight = collider.shape == ColliderShape::Capsule ? collider.halfHeight : 0.0f;
        half = {radius, radius + straight, radius};
    }
    const Vector3f& p = collider.position;
    const Quaternionf q = collider.orientation.normalized();
    return {{p.x(), p.y(), p.z(), radius},
            {q.x(), q.y(), q.z(), q.w()},
            {half.x(), half.y(), half.z(), 0.0f},
            {collider.color.x(), collider.color.y(), collider.color.z(), static_cast<float>(collider.shape)}};
}

}  // namespace

StaticGeometry::StaticGeometry(const Gpu& gpu, const World& world, const SceneExtent& extent)
    : meshes_(gpu, world),
      planeProgram_(Program::graphics(gpu, "render/colliders/plane.vert", "render/colliders/plane.frag")),
      shapeProgram_(Program::graphics(gpu, "render/colliders/collider.vert", "render/colliders/collider.frag")),
      shadowProgram_(Program::graphics(gpu, "render/colliders/collider.vert", "render/colliders/collider_shadow.frag",
                                       {{"LIGHT_VIEW", "1"}}))
{
    std::vector<gpu::ColliderInstance> instances;
    for (uint32_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& collider = world.colliders[i];
        if (!collider.visible || collider.grid != NO_INDEX) continue;
        if (collider.shape != ColliderShape::Plane) {
            instances.push_back(instanceOf(collider));
            continue;
        }
        const Vector3f n = collider.orientation.normalized() * Vector3f::UnitY(), &c = collider.color;
        planes_.push_back({{n.x(), n.y(), n.z(), n.dot(collider.position)},
                           {c.x(), c.y(), c.z(), i == extent.groundCollider ? 1.0f : 0.0f}});
    }
    shapes_ = Buffer<gpu::ColliderInstance>("collider shapes", instances);
    glGenVertexArrays(1, &vertexArray_);
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, shapes_.id());
    for (GLuint i = 0; i < INSTANCE_VECTORS; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(gpu::ColliderInstance),
                              reinterpret_cast<const void*>(i * sizeof(gpu::vec4)));
        glVertexAttribDivisor(i, 1);
    }
}

StaticGeometry::~StaticGeometry()
{
    glDeleteVertexArrays(1, &vertexArray_);
}

void StaticGeometry::draw() const
{
    glUseProgram(planeProgram_.id());
    glBindVertexArray(vertexArray_);
    for (const Plane& plane : planes_) {
        glUniform4fv(0, 1, &plane.equation.x);
        glUniform4fv(1, 1, &plane.color.x);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    meshes_.draw();
    glUseProgram(shapeProgram_.id());
    drawShapes();
}

void StaticGeometry::drawShadow() const
{
    meshes_.drawShadow();
    glUseProgram(shadowProgram_.id());
    drawShapes();
}

void StaticGeometry::drawShapes() const
{
    if (shapes_.size() == 0) return;
    glBindVertexArray(vertexArray_);
    // The far sides of the boxes: they are there even when the eye is inside.
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, BOX_STRIP, static_cast<GLsizei>(shapes_.size()));
    glDisable(GL_CULL_FACE);
}

}  // namespace knuckle
