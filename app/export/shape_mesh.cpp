#include "app/export/shape_mesh.h"

namespace knuckle {

namespace {

/// Parts along an edge of a face: odd, so that no corner lies in the middle of a side, which the middle part spans.
/// Rounded edges of boxes are narrow; all that is seen of balls and capsules is round.
int partsOf(const BodyShape& shape)
{
    return shape.halfSides.minCoeff() > 0.0f ? 3 : 9;
}

/// A point of a face of the cube from -1 to 1: of the two faces across an axis, that on one side.
Vector3f cubePoint(int axis, float side, float u, float v)
{
    Vector3f point;
    point[axis] = side;
    point[(axis + 1) % 3] = u;
    point[(axis + 2) % 3] = v;
    return point;
}

void addVertex(Rig& rig, const BodyShape& shape, uint32_t bone, const Vector3f& color, const Vector3f& cube)
{
    const Vector3f way = cube.normalized(), corner = shape.halfSides.array() * cube.array().sign();
    SkinWeights skin;
    skin.bones[0] = bone;
    skin.weights[0] = 1.0f;
    rig.model.vertices.push_back(shape.middle + corner + shape.radius * way);
    rig.model.skin.push_back(skin);
    rig.model.surface.vertices.push_back({way, {0, 0}, color});
}

}  // namespace

void addShape(Rig& rig, const BodyShape& shape, uint32_t bone, const Vector3f& color)
{
    const int parts = partsOf(shape);
    const auto row = static_cast<uint32_t>(parts + 1);
    const auto place = [parts](int k) { return -1.0f + 2.0f * static_cast<float>(k) / static_cast<float>(parts); };
    for (int face = 0; face < 6; ++face) {
        const auto first = static_cast<uint32_t>(rig.model.vertices.size());
        const bool isFar = face % 2 == 0;
        for (int j = 0; j <= parts; ++j)
            for (int i = 0; i <= parts; ++i)
                addVertex(rig, shape, bone, color, cubePoint(face / 2, isFar ? 1.0f : -1.0f, place(i), place(j)));
        for (uint32_t j = 0; j + 1 < row; ++j)
            for (uint32_t i = 0; i + 1 < row; ++i) {
                const uint32_t a = first + j * row + i, b = a + 1, c = a + row, d = c + 1;
                if (isFar) rig.model.triangles.insert(rig.model.triangles.end(), {{a, b, d}, {a, d, c}});
                else rig.model.triangles.insert(rig.model.triangles.end(), {{a, d, b}, {a, c, d}});
            }
    }
}

}  // namespace knuckle
