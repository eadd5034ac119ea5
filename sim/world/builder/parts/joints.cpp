#include "sim/world/builder/parts/joints.h"

#include <fmt/format.h>

#include <stdexcept>

namespace knuckle {

const char* jointTypeName(JointType type)
{
    switch (type) {
        case JointType::Ball: return "ball";
        case JointType::Hinge: return "hinge";
        case JointType::Stiff: return "stiff";
        case JointType::Universal: return "universal";
    }
    return "unknown";
}

Vector3f alongOf(const JointSpec& spec)
{
    const Vector3f axis = spec.axis.normalized();
    return (spec.along - axis * axis.dot(spec.along)).normalized();
}

JointPlaces jointPlaces(const JointSpec& spec, float diameter)
{
    const Vector3f axis = spec.axis.normalized();
    const Vector3f along = alongOf(spec);
    if (!axis.allFinite() || !along.allFinite() || axis.norm() < 0.5f || along.norm() < 0.5f)
        throw std::logic_error(fmt::format("joint \"{}\": axis and direction must be two vectors that are neither zero "
                                           "nor parallel",
                                           spec.name));
    const Vector3f u = diameter * axis;
    const Vector3f v = diameter * along.cross(axis);
    const Vector3f& p = spec.anchor;
    JointPlaces places;
    switch (spec.type) {
        case JointType::Ball: places.shared = {p}; break;
        case JointType::Hinge:
            places.shared = {p - u, p, p + u};
            if (spec.limitSide != 0) {
                const Vector3f side = static_cast<float>(spec.limitSide) * v;
                places.limits = {p + side - u, p + side + u};
            }
            break;
        case JointType::Stiff: places.shared = {p - u - v, p + u - v, p - u + v, p + u + v}; break;
        case JointType::Universal:
            places.sharedWithParent = {p - u, p + u};
            places.sharedWithChild = {p - v, p + v};
            places.middle = {p};
            break;
    }
    return places;
}

}  // namespace knuckle
