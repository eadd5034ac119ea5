#include <algorithm>
#include <cmath>

#include "tools/humanoid/humanoid_look.h"

namespace knuckle {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Vector3d SKULL{0, 1.636, 0.010}, SKULL_RADII{0.076, 0.106, 0.098};
constexpr double BLEND = 0.024, FEATURE_BLEND = 0.010;  // [m]
const Vector3d HEAD_CENTRE{0, 1.62, 0.0};
constexpr double HEAD_REACH = 0.17;  // [m]

const Limb JAW[] = {
    {{0, 1.590, 0.025}, {0, 1.567, 0.055}, 0.052, 0.034},
    {{0, 1.547, 0.070}, {0.012, 1.548, 0.067}, 0.020, 0.019},      // chin
    {{0.036, 1.616, 0.070}, {0.050, 1.622, 0.050}, 0.026, 0.024},  // cheek
};
const Limb NOSE[] = {
    {{0, 1.645, 0.099}, {0, 1.615, 0.112}, 0.0078, 0.0085},
    {{0, 1.612, 0.1135}, {0, 1.608, 0.1125}, 0.0102, 0.0095},
    {{0.0100, 1.606, 0.109}, {0.0105, 1.607, 0.105}, 0.0070, 0.0070},  // wing
};
const Limb EAR[] = {
    {{0.078, 1.607, 0.004}, {0.084, 1.622, -0.002}, 0.0065, 0.0080},
    {{0.084, 1.622, -0.002}, {0.088, 1.646, -0.010}, 0.0080, 0.0110},
};

const Vector3d EYE{0.0325, 1.640, 0.0845};
constexpr double EYE_RADIUS = 0.0175, LID = 0.0015;                   // [m]
constexpr double HALF_OPEN = 0.0145, UPPER = 0.0058, LOWER = 0.0046;  // of the opening between the lids [m]
constexpr double LASH = 0.0018, IRIS_RADIUS = 0.0068, PUPIL_RADIUS = 0.0031;

constexpr double MOUTH_HEIGHT = 1.577, MOUTH_WIDTH = 0.0245;  // its half [m]

// How far inside the opening of the lids a place in front of the eye is [m].
double eyeOpening(const Vector3d& p)
{
    const double u = p.x() - EYE.x(), v = p.y() - EYE.y() - 0.10 * u, arch = 1.0 - u * u / (HALF_OPEN * HALF_OPEN);
    return std::min(UPPER * arch - v, v + LOWER * arch);
}

double brow(const Vector3d& p)
{
    const Vector2d q = p.head<2>(), inner(0.014, 1.6600), top(0.035, 1.6640), outer(0.050, 1.6570);
    const auto part = [&](const Vector2d& a, const Vector2d& b, double from, double to) {
        const double t = std::clamp((q - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        return (q - a - t * (b - a)).norm() - (from + t * (to - from));
    };
    return std::min(part(inner, top, 0.0026, 0.0032), part(top, outer, 0.0032, 0.0010));
}

// Height of the line between the lips, with the corners a little higher [m].
double mouthHeight(const Vector3d& p)
{
    return MOUTH_HEIGHT + 0.0030 * std::pow(p.x() / MOUTH_WIDTH, 2);
}

// Negative on the lips, seen from the front.
double lips(const Vector3d& p)
{
    const double u = p.x() / MOUTH_WIDTH, v = p.y() - mouthHeight(p), arch = 1.0 - u * u;
    const double bow = 0.0060 * arch - 0.0016 * std::exp(-40.0 * u * u);
    return -std::min(bow - v, v + 0.0075 * std::pow(std::max(arch, 0.0), 0.8) - 0.003 * std::min(arch, 0.0));
}

bool before(const Vector3d& p)
{
    return p.z() > 0.045;
}

double skinDistance(const Vector3d& left, double body)
{
    double d = melt(body, ellipsoidDistance(left, SKULL, SKULL_RADII), BLEND);
    for (const Limb& limb : JAW) d = melt(d, limbDistance(left, limb), BLEND);
    // Cuts the sockets, then adds their contents.
    d = -melt(-d, limbDistance(left, {{0.028, 1.638, 0.117}, {0.044, 1.638, 0.108}, 0.020, 0.018}), 0.012);
    for (const Limb& limb : NOSE) d = melt(d, limbDistance(left, limb), FEATURE_BLEND);
    for (const Limb& limb : EAR) d = melt(d, limbDistance(left, limb), FEATURE_BLEND);
    const double open = before(left) ? std::clamp(eyeOpening(left) / 0.001 + 0.5, 0.0, 1.0) : 0.0;
    d = melt(d, (left - EYE).norm() - EYE_RADIUS + LID * open, 0.004);
    if (!before(left)) return d;
    const double lip = std::clamp(-lips(left) / 0.004, -0.5, 1.0);
    const double line = std::exp(-std::pow((left.y() - mouthHeight(left)) / 0.0016, 2)) * (lip > 0.0 ? lip : 0.0);
    return d - 0.0030 * std::max(lip, 0.0) + 0.0030 * line - 0.0012 * std::clamp(-brow(left) / 0.002, 0.0, 1.0);
}

double hairDistance(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    // Hair is combed from the parting.
    const double way = std::atan2(p.y() - 1.63, p.x() - 0.02) + 0.6 * (p.z() + 0.02) / 0.1;
    const double strands = 0.0012 * std::sin(26.0 * std::atan2(p.z() - 0.03, 0.05 + std::abs(p.x() - 0.03)) + way);
    double cap = ellipsoidDistance(p, {0, 1.647, -0.001}, {0.085, 0.102, 0.101}) - strands;
    const double face = ellipsoidDistance(left, {0, 1.594, 0.115}, {0.081, 0.096, 0.082});
    cap = -melt(-cap, face, 0.01);
    const double ear = limbDistance(left, {{0.080, 1.600, 0.006}, {0.092, 1.648, -0.006}, 0.016, 0.018});
    cap = -melt(-cap, ear, 0.008);
    const double nape = (1.556 - p.y()) * 0.9 + 0.55 * (p.z() + 0.06);
    cap = -melt(-cap, -nape, 0.01);
    const Limb locks[] = {
        {{0.030, 1.728, 0.062}, {-0.030, 1.714, 0.092}, 0.020, 0.017},
        {{-0.030, 1.714, 0.092}, {-0.072, 1.684, 0.058}, 0.017, 0.007},
        {{0.030, 1.730, 0.050}, {-0.050, 1.712, 0.066}, 0.022, 0.018},
        {{-0.050, 1.712, 0.066}, {-0.082, 1.662, 0.022}, 0.018, 0.008},
        {{0.034, 1.727, 0.060}, {0.068, 1.698, 0.062}, 0.016, 0.012},
        {{0.068, 1.698, 0.062}, {0.080, 1.662, 0.022}, 0.012, 0.007},
    };
    for (const Limb& lock : locks) cap = melt(cap, limbDistance(p, lock) - 0.5 * strands, 0.008);
    return cap;
}

}  // namespace

double headDistance(const Vector3d& p, double body)
{
    const double outside = (p - HEAD_CENTRE).norm() - HEAD_REACH;
    if (outside > BLEND + std::max(body, 0.0)) return body;
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    return melt(skinDistance(left, body), hairDistance(p), 0.003);
}

HumanoidRegion headRegionAt(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    if (hairDistance(p) < skinDistance(left, 1.0) && p.y() > 1.52) return HAIR;
    if (!before(left)) return BODY_SKIN;
    if ((left - EYE).norm() < EYE_RADIUS + 0.003) {
        const double open = eyeOpening(left);
        const Eigen::Vector2d at = (left - EYE).head<2>() - Vector2d(-0.0005, 0.0008);
        if (open > 0.0) return at.norm() < PUPIL_RADIUS ? PUPIL : at.norm() < IRIS_RADIUS ? IRIS : EYE_WHITE;
        if (open > -LASH && left.y() > EYE.y() + 0.0005) return LASHES;
    }
    if (brow(left) < 0.0) return BROW;
    if (lips(left) < 0.0)
        return std::abs(left.y() - mouthHeight(left)) < 0.0007 && left.x() < MOUTH_WIDTH - 0.003 ? MOUTH : LIPS;
    return BODY_SKIN;
}

double featureDistance(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    const double mouth = segmentDistance(left, {0, MOUTH_HEIGHT, 0.1}, {0.02, MOUTH_HEIGHT, 0.088}) - 0.008;
    const double eye = segmentDistance(left, EYE + Vector3d(-0.008, 0, 0.014), EYE + Vector3d(0.01, 0, 0.012)) - 0.0068;
    return std::min(eye, mouth + 0.004);
}

}  // namespace knuckle
