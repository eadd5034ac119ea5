#include "app/scene/scene_places.h"

#include "app/json/fields.h"
#include "sim/base/angles.h"

namespace knuckle {

Quaternionf rotationOf(const Vector3f& degrees)
{
    const Vector3f angles = degrees * DEGREE;
    return Quaternionf(Eigen::AngleAxisf(angles.z(), Vector3f::UnitZ()) *
                       Eigen::AngleAxisf(angles.y(), Vector3f::UnitY()) *
                       Eigen::AngleAxisf(angles.x(), Vector3f::UnitX()));
}

Quaternionf readRotation(const Json& json)
{
    if (!json.contains("rotation")) return Quaternionf::Identity();
    Vector3f degrees;
    readValue(json["rotation"], degrees);
    return rotationOf(degrees);
}

Region readRegion(const Json& json)
{
    Region region;
    readValue(json["position"], region.position);
    region.orientation = readRotation(json);
    const std::string shape = json["shape"];
    if (shape == "box") {
        readValue(json["size"], region.halfExtents);
        region.halfExtents *= 0.5f;
    }
    if (json.contains("radius")) readValue(json["radius"], region.radius);
    if (json.contains("length")) region.halfHeight = 0.5f * json["length"].get<float>();
    region.shape = shape == "box"      ? ColliderShape::Box
                   : shape == "sphere" ? ColliderShape::Sphere
                   : shape == "plane"  ? ColliderShape::Plane
                                       : ColliderShape::Capsule;
    return region;
}

}  // namespace knuckle
