#include "render/view/bounds_margin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>

namespace knuckle {

namespace {

std::span<const Link> linksOf(const World& world, const Body& body)
{
    return std::span(world.links).subspan(body.linkStart, body.linkCount);
}

/// Along the axes of the rest pose.
float shapeMargin(const World& world, const BodyShape& shape)
{
    const Body& body = world.bodies[shape.body];
    Eigen::AlignedBox3f spheres;
    for (const Link& link : linksOf(world, body)) spheres.extend(body.restCentre + link.restOffset);
    const Vector3f reach = shape.halfSides + Vector3f::Constant(shape.radius - world.particleRadius);
    return std::max((spheres.min() - (shape.middle - reach)).maxCoeff(),
                    (shape.middle + reach - spheres.max()).maxCoeff());
}

/// Of a vertex from the body that moves it most.
float vertexMargin(const World& world, const Object& object, const SkinVertex& vertex)
{
    const auto most = std::ranges::max_element(vertex.weights) - vertex.weights.begin();
    const Body& body = world.bodies[object.bodyStart + vertex.bodies[static_cast<size_t>(most)]];
    float nearest = std::numeric_limits<float>::infinity();
    for (const Link& link : linksOf(world, body))
        nearest = std::min(nearest, (body.restCentre + link.restOffset - vertex.position).norm());
    return nearest - world.particleRadius;
}

}  // namespace

float boundsMargin(const World& world, float size)
{
    float margin = 0.0f;
    for (const BodyShape& shape : world.bodyShapes) margin = std::max(margin, shapeMargin(world, shape));
    for (const Skin& skin : world.skins)
        if (isDrawn(skin) && !skin.objects.empty())
            for (const SkinVertex& vertex : skin.mesh->vertices)
                margin = std::max(margin, vertexMargin(world, world.objects[skin.objects[0]], vertex));
    return std::min(margin, 0.5f * size);
}

}  // namespace knuckle
