#include "render/colliders/collider_meshes.h"

#include <cmath>

#include "shared/frame_types.h"

namespace knuckle {

namespace {

constexpr GLsizei CORNER_FLOATS = 6;
/// Cosine of the angle from which an edge is drawn sharp.
constexpr float CREASE = 0.77f;

Vector3f areaNormal(const ColliderGrid& grid, const std::array<uint32_t, 3>& triangle)
{
    const Vector3f& a = grid.vertices[triangle[0]];
    return (grid.vertices[triangle[1]] - a).cross(grid.vertices[triangle[2]] - a);
}

/// Means over the triangles around each vertex, by area.
std::vector<Vector3f> vertexNormals(const ColliderGrid& grid)
{
    std::vector<Vector3f> normals(grid.vertices.size(), Vector3f::Zero());
    for (const auto& triangle : grid.triangles)
        for (const uint32_t vertex : triangle) normals[vertex] += areaNormal(grid, triangle);
    for (Vector3f& normal : normals) normal.normalize();
    return normals;
}

void addCorners(std::vector<float>& out, const Collider& collider, const ColliderGrid& grid)
{
    const std::vector<Vector3f> normals = vertexNormals(grid);
    const Eigen::Matrix3f turn = collider.orientation.normalized().toRotationMatrix();
    for (const auto& triangle : grid.triangles) {
        const Vector3f flat = areaNormal(grid, triangle).normalized();
        for (const uint32_t vertex : triangle) {
            const Vector3f place = turn * grid.vertices[vertex] + collider.position;
            const Vector3f normal = turn * (normals[vertex].dot(flat) < CREASE ? flat : normals[vertex]);
            out.insert(out.end(), place.begin(), place.end());
            out.insert(out.end(), normal.begin(), normal.end());
        }
    }
}

}  // namespace

ColliderMeshes::ColliderMeshes(const Gpu& gpu, const World& world)
    : program_(Program::graphics(gpu, "render/colliders/collider_mesh.vert", "render/colliders/collider_mesh.frag")),
      shadowProgram_(Program::graphics(gpu, "render/colliders/collider_mesh.vert",
                                       "render/colliders/collider_mesh_shadow.frag",
                                       {{"LIGHT_VIEW", "1"}}))
{
    std::vector<float> corners;
    for (const Collider& collider : world.colliders) {
        const bool hasMesh = collider.shape == ColliderShape::Mesh || collider.shape == ColliderShape::Heightfield;
        if (!hasMesh || !collider.visible) continue;
        const size_t first = corners.size();
        addCorners(corners, collider, world.colliderGrids[collider.grid]);
        parts_.push_back({static_cast<GLint>(first / CORNER_FLOATS),
                          static_cast<GLsizei>((corners.size() - first) / CORNER_FLOATS),
                          {collider.color.x(), collider.color.y(), collider.color.z()}});
    }
    corners_ = Buffer<float>("collider meshes", corners);
    glGenVertexArrays(1, &vertexArray_);
    glBindVertexArray(vertexArray_);
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    for (GLuint attribute : {0u, 1u}) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, CORNER_FLOATS * sizeof(float),
                              reinterpret_cast<const void*>(attribute * 3 * sizeof(float)));
    }
}

ColliderMeshes::~ColliderMeshes()
{
    glDeleteVertexArrays(1, &vertexArray_);
}

void ColliderMeshes::draw() const
{
    glUseProgram(program_.id());
    glBindVertexArray(vertexArray_);
    for (const Part& part : parts_) {
        glUniform3fv(0, 1, part.color.data());
        glDrawArrays(GL_TRIANGLES, part.first, part.count);
    }
}

void ColliderMeshes::drawShadow() const
{
    glUseProgram(shadowProgram_.id());
    glBindVertexArray(vertexArray_);
    for (const Part& part : parts_) glDrawArrays(GL_TRIANGLES, part.first, part.count);
}

}  // namespace knuckle
