#include "sim/world/matter/body_shape.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "sim/world/world.h"

namespace knuckle {

bool BodyShape::contains(const Eigen::Vector3f& place) const
{
    const Eigen::Vector3f beyond = ((place - middle).cwiseAbs() - halfSides).cwiseMax(0.0f);
    return beyond.norm() <= 1.001f * radius;
}

BodyShape shapeAround(std::span<const Eigen::Vector3f> positions, float particleRadius)
{
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& position : positions) box.extend(position);
    return {0, box.center(), 0.5f * box.sizes(), particleRadius};
}

void validateBodyShapes(const World& world)
{
    for (const BodyShape& shape : world.bodyShapes) {
        if (shape.body >= world.bodies.size()) throw std::logic_error("a shape's body is not there");
        const bool finite = shape.middle.allFinite() && shape.halfSides.allFinite() && std::isfinite(shape.radius);
        if (!finite || shape.radius <= 0.0f || shape.halfSides.minCoeff() < 0.0f)
            throw std::logic_error("a body's shape is not finite or has a size below 0");
    }
}

}  // namespace knuckle
