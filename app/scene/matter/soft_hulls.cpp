#include "app/scene/matter/soft_hulls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim/rig/skin/skin_mesh.h"
#include "sim/world/matter/body_shape.h"

namespace knuckle {

namespace {

/// How far a particle's weight reaches, and how far vertices are from each other [diameters].
constexpr float REACH = 0.8f, PITCH = 0.6f;

/// A mesh of which vertices at one place are one.
struct WeldedMesh {
    std::vector<Vector3f> places;
    std::vector<std::array<uint32_t, 3>> triangles;

    /// @param unit places that differ by less are one [m].
    explicit WeldedMesh(float unit) : unit_(unit) {}

    uint32_t vertex(const Vector3f& place)
    {
        std::array<long, 3> key{};
        for (int k = 0; k < 3; ++k) key[k] = std::lround(place[k] / unit_);
        const auto [found, isNew] = known_.emplace(key, static_cast<uint32_t>(places.size()));
        if (isNew) places.push_back(place);
        return found->second;
    }

    void add(uint32_t a, uint32_t b, uint32_t c)
    {
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }

private:
    float unit_;
    std::map<std::array<long, 3>, uint32_t> known_;
};

/// A row of points across a rounded box: around an edge, along the side, around the other edge.
struct RowPoint {
    float along;  ///< On the box [m].
    float turn;   ///< -1 ... 1: an eighth of a turn to either side.
};

std::vector<RowPoint> rowAcross(float half, float radius, float pitch)
{
    const int curve = std::clamp(static_cast<int>(std::ceil(0.7854f * radius / pitch)), 2, 16);
    const int flat = static_cast<int>(std::ceil(2.0f * half / pitch));
    std::vector<RowPoint> row;
    for (int k = -curve; k < 0; ++k) row.push_back({-half, float(k) / float(curve)});
    for (int k = 0; k <= flat; ++k) row.push_back({flat > 0 ? half * (2.0f * float(k) / float(flat) - 1.0f) : 0.0f, 0});
    for (int k = 1; k <= curve; ++k) row.push_back({half, float(k) / float(curve)});
    return row;
}

/// The face of a rounded box towards an axis.
void addFace(WeldedMesh& mesh, const BodyShape& shape, int axis, float sign, float pitch)
{
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    const auto rows = rowAcross(shape.halfSides[second], shape.radius, pitch);
    const auto columns = rowAcross(shape.halfSides[third], shape.radius, pitch);
    std::vector<uint32_t> vertices;
    for (const RowPoint& row : rows)
        for (const RowPoint& column : columns) {
            Vector3f box, away;
            box[axis] = sign * shape.halfSides[axis];
            box[second] = row.along;
            box[third] = column.along;
            away[axis] = sign;
            away[second] = std::tan(0.7853982f * row.turn);
            away[third] = std::tan(0.7853982f * column.turn);
            vertices.push_back(mesh.vertex(shape.middle + box + shape.radius * away.normalized()));
        }
    const auto width = static_cast<uint32_t>(columns.size());
    for (uint32_t j = 0; j + 1 < rows.size(); ++j)
        for (uint32_t k = 0; k + 1 < width; ++k) {
            const uint32_t a = vertices[j * width + k], b = vertices[j * width + k + 1];
            const uint32_t c = vertices[(j + 1) * width + k], d = vertices[(j + 1) * width + k + 1];
            mesh.add(a, sign > 0 ? c : b, sign > 0 ? b : c);
            mesh.add(b, sign > 0 ? c : d, sign > 0 ? d : c);
        }
}

/// How far particles reach in the mean of directions: across y, or in all [m].
float meanReach(std::span<const Vector3f> positions, bool flat)
{
    constexpr int DIRECTIONS = 200;
    float sum = 0.0f;
    for (int k = 0; k < DIRECTIONS; ++k) {
        const float y = flat ? 0.0f : 1.0f - (2.0f * float(k) + 1.0f) / DIRECTIONS, turn = 2.3999632f * float(k);
        const float wide = std::sqrt(1.0f - y * y);
        const Vector3f way(wide * std::cos(turn), y, wide * std::sin(turn));
        float reach = 0.0f;
        for (const Vector3f& position : positions) reach = std::max(reach, position.dot(way));
        sum += reach;
    }
    return sum / DIRECTIONS;
}

/// A ball's or capsule's is as large as its particles reach in the mean, since its lattice has steps.
BodyShape shapeOf(const std::string& kind, std::span<const Vector3f> positions, float radius)
{
    BodyShape shape = shapeAround(positions, radius);
    if (kind == "box") return shape;
    const float reach = meanReach(positions, kind == "capsule") + radius;
    const float half = kind == "capsule" ? std::max(shape.halfSides.y() + radius - reach, 0.0f) : 0.0f;
    return {0, {0, 0, 0}, {0, half, 0}, reach};
}

}  // namespace

std::shared_ptr<const SoftHull> makeSoftHull(const ObjectEntry& entry, std::span<const Vector3f> positions)
{
    const float diameter = entry.context.builder.diameter();
    const std::string kind = entry.json["shape"];
    WeldedMesh mesh(1e-3f * diameter);
    if (kind == "mesh") {
        const Actor& actor = entry.actor();
        const SkinMesh skin = makeSkinMesh(actor, *entry.context.files.drawnModel(actor.model));
        std::vector<uint32_t> vertices;
        for (const SkinVertex& vertex : skin.vertices) vertices.push_back(mesh.vertex(vertex.position));
        for (const auto& [a, b, c] : skin.triangles) mesh.add(vertices[a], vertices[b], vertices[c]);
    } else {
        const BodyShape shape = shapeOf(kind, positions, 0.5f * diameter);
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {-1.0f, 1.0f}) addFace(mesh, shape, axis, sign, PITCH * diameter);
    }
    auto hull = std::make_shared<SoftHull>();
    hull->vertices = bindHull(mesh.places, positions, REACH * diameter);
    hull->triangles = mesh.triangles;
    return hull;
}

}  // namespace knuckle
