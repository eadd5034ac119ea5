#include "render/colliders/mesh_pass.h"

#include <array>

#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"

namespace knuckle {

namespace {

/// Cosine of the angle above which an edge is drawn sharp.
constexpr float CREASE = 0.77f;

Vector3f areaNormal(const ColliderGrid& grid, const std::array<uint32_t, 3>& triangle)
{
    const Vector3f& a = grid.vertices[triangle[0]];
    return (grid.vertices[triangle[1]] - a).cross(grid.vertices[triangle[2]] - a);
}

/// Mean normals of the triangles around each vertex, weighted by area.
std::vector<Vector3f> vertexNormals(const ColliderGrid& grid)
{
    std::vector<Vector3f> normals(grid.vertices.size(), Vector3f::Zero());
    for (const auto& triangle : grid.triangles)
        for (const uint32_t vertex : triangle) normals[vertex] += areaNormal(grid, triangle);
    for (Vector3f& normal : normals) normal.normalize();
    return normals;
}

/// Two vectors a corner, in the grid's frame: its place, w: `mesh`; its normal, w: `finish`.
void addCorners(std::vector<gpu::vec4>& out, const ColliderGrid& grid, size_t mesh, uint32_t finish)
{
    const std::vector<Vector3f> normals = vertexNormals(grid);
    for (const auto& triangle : grid.triangles) {
        const Vector3f flat = areaNormal(grid, triangle).normalized();
        for (const uint32_t vertex : triangle) {
            const Vector3f place = grid.vertices[vertex];
            const Vector3f normal = normals[vertex].dot(flat) < CREASE ? flat : normals[vertex];
            out.push_back({place.x(), place.y(), place.z(), static_cast<float>(mesh)});
            out.push_back({normal.x(), normal.y(), normal.z(), static_cast<float>(finish)});
        }
    }
}

}  // namespace

MeshPass::MeshPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderTargets& targets)
{
    const Finishes finishes(world);
    std::vector<gpu::vec4> corners, colors;
    for (size_t c = 0; c < world.colliders.size(); ++c) {
        const Collider& collider = world.colliders[c];
        const bool hasMesh = collider.shape == ColliderShape::Mesh || collider.shape == ColliderShape::Heightfield;
        if (!hasMesh || !collider.visible) continue;
        addCorners(corners, world.colliderGrids[collider.grid], colors.size(), finishes.alphaOf(collider.finish));
        colors.push_back({collider.color.x(), collider.color.y(), collider.color.z(), static_cast<float>(c)});
    }
    corners_ = {"meshCorners", std::span<const gpu::vec4>(corners)};
    colors_ = {"meshColors", std::span<const gpu::vec4>(colors)};
    table.add(Lifetime::Constant, corners_, colors_);
    meshes_ = DrawPass(gpu, table,
                       {"colliders/collider_mesh", "colliders/collider_mesh",
                        joined({finishes.patternDefines(), targets.layerDefines()})},
                       {"colliderPlaces", "meshCorners", "meshColors", "finishes"}, targets.geometry);
    shadow_ = DrawPass(gpu, table, {"colliders/collider_mesh", "colliders/collider_mesh_shadow", {{"LIGHT_VIEW", "1"}}},
                       {"colliderPlaces", "meshCorners", "meshColors"}, targets.shadowMap);
}

}  // namespace knuckle
