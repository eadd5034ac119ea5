#include "app/export/shape_mesh.h"

#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

/// A coordinate on the cube from -1 to 1 that the shape's roundings are a picture of, and the side of the box it is on.
struct Coordinate {
    float value, side;
};

/// From one side of the box to the other, evenly by angle; where it has a width, its face lies between the two zeros.
/// Rounded edges of boxes are narrow, while balls and capsules are round all over.
std::vector<Coordinate> coordinates(const BodyShape& shape, int axis)
{
    const int parts = shape.halfSides.minCoeff() > 0.0f ? 2 : 4;
    const auto at = [parts](int k) {
        return std::tan(0.25f * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(parts));
    };
    std::vector<Coordinate> all;
    for (int k = -parts; k <= 0; ++k) all.push_back({at(k), -1.0f});
    for (int k = shape.halfSides[axis] > 0.0f ? 0 : 1; k <= parts; ++k) all.push_back({at(k), 1.0f});
    return all;
}

void addVertex(Rig& rig, const BodyShape& shape, uint32_t bone, const Vector3f& color,
               const std::array<Coordinate, 3>& c)
{
    const Vector3f way = Vector3f(c[0].value, c[1].value, c[2].value).normalized();
    const Vector3f corner = shape.halfSides.cwiseProduct(Vector3f(c[0].side, c[1].side, c[2].side));
    addRigidVertex(rig, bone, shape.middle + corner + shape.radius * way, way, color);
}

}  // namespace

void addShape(Rig& rig, const BodyShape& shape, uint32_t bone, const Vector3f& color)
{
    for (size_t face = 0; face < 6; ++face) {
        const size_t across = face / 2, along = (across + 1) % 3, up = (across + 2) % 3;
        const bool isFar = face % 2 == 0;
        const auto columns = coordinates(shape, static_cast<int>(along)),
                   rows = coordinates(shape, static_cast<int>(up));
        const auto first = static_cast<uint32_t>(rig.model.vertices.size());
        const auto width = static_cast<uint32_t>(columns.size()), height = static_cast<uint32_t>(rows.size());
        std::array<Coordinate, 3> c = {};
        c[across] = isFar ? Coordinate{1.0f, 1.0f} : Coordinate{-1.0f, -1.0f};
        for (const Coordinate& row : rows)
            for (const Coordinate& column : columns) {
                c[along] = column, c[up] = row;
                addVertex(rig, shape, bone, color, c);
            }
        for (uint32_t j = 0; j + 1 < height; ++j)
            for (uint32_t i = 0; i + 1 < width; ++i) {
                const uint32_t a = first + j * width + i, b = a + 1, l = a + width, d = l + 1;
                if (isFar) rig.model.triangles.insert(rig.model.triangles.end(), {{a, b, d}, {a, d, l}});
                else rig.model.triangles.insert(rig.model.triangles.end(), {{a, d, b}, {a, l, d}});
            }
    }
}

}  // namespace knuckle
