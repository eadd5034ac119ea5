#include "sim/world/space/frames.h"

#include <cmath>

namespace knuckle {

using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr float OPPOSITE = -0.99f;  // cosine below which floats have too few digits for a turn
constexpr float STEEP = 0.999f;     // height of a direction above which up is no reference

}  // namespace

Quaternionf turnBetween(const Vector3f& from, const Vector3f& to)
{
    const Vector3d a = from.cast<double>().stableNormalized(), b = to.cast<double>().stableNormalized();
    if (a.isZero() || b.isZero()) return Quaternionf::Identity();
    if (a.dot(b) > OPPOSITE) return Quaternionf::FromTwoVectors(from, to);
    const Vector3d axis = a.cross(b);
    // 1 + a.b, computed from the small sum of two nearly opposite directions.
    const double w = 0.5 * (a + b).squaredNorm();
    Quaterniond turn(w, axis.x(), axis.y(), axis.z());
    if (!(turn.norm() > 0.0)) turn.vec() = a.unitOrthogonal();
    return turn.normalized().cast<float>();
}

Vector3f levelRight(const Vector3f& back)
{
    const Vector3f up = std::abs(back.y()) > STEEP ? Vector3f(-Vector3f::UnitZ()) : Vector3f(Vector3f::UnitY());
    return up.cross(back).normalized();
}

}  // namespace knuckle
