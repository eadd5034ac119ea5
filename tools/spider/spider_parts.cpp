#include "tools/spider/spider_parts.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

enum Metal : Region { PAINT, STEEL, DARK, RUBBER, LENS, LENS_RIM, LENS_CORE };

constexpr double CELL = 0.0041;  // the finest [m]
constexpr double WELD = 0.006;   // over which the parts of a shell blend into each other [m]

// A point of a leg in its own directions: out from the hip, up, and across.
struct InLeg {
    const SpiderLeg* leg;
    bool mirror;

    Vector3d operator()(const Vector3d& p) const
    {
        const Vector3d off = Vector3d(mirror ? -p.x() : p.x(), p.y(), p.z()) - leg->hip;
        return {off.dot(leg->out), off.y(), off.dot(leg->out.cross(Vector3d::UnitY()))};
    }
};

Vector3d flat(const Vector2d& place, double across = 0.0)
{
    return {place.x(), place.y(), across};
}

// A bar with a rectangular section that tapers from one place to another.
double bar(const Vector3d& p, const Vector2d& a, const Vector2d& b, const Vector2d& from, const Vector2d& to,
           double rounding)
{
    const Vector2d way = (b - a).normalized(), off = p.head<2>() - a;
    const double length = (b - a).norm(), along = off.dot(way), part = std::clamp(along / length, 0.0, 1.0);
    const Vector2d half = from + part * (to - from);
    const Vector3d local(along - 0.5 * length, off.x() * way.y() - off.y() * way.x(), p.z());
    return 0.95 * boxDistance(local, Vector3d::Zero(), {0.5 * length, half.x(), half.y()}, rounding);
}

// The position along the line from one place to another, 0 ... 1, and beyond.
double along(const Vector3d& p, const Vector2d& a, const Vector2d& b)
{
    return (p.head<2>() - a).dot(b - a) / (b - a).squaredNorm();
}

double coxaDistance(const Vector3d& p)
{
    const double hub = cylinderDistance(p, {0, -0.050, 0}, {0, 0.050, 0}, 0.048, 0.010);
    const double arm = boxDistance(p, {0.045, 0, 0}, {0.050, 0.034, 0.026}, 0.010);
    return melt(hub, arm, WELD);
}

Region coxaRegion(const Vector3d& p)
{
    return std::hypot(p.x(), p.z()) < 0.049 ? (std::abs(p.y()) > 0.036 ? STEEL : DARK) : STEEL;
}

double femurDistance(const Vector3d& p)
{
    const double hub = cylinderDistance(p, flat(FEMUR, -0.040), flat(FEMUR, 0.040), 0.046, 0.008);
    const double beam = bar(p, FEMUR, TIBIA, {0.040, 0.030}, {0.032, 0.026}, 0.012);
    const double knee = cylinderDistance(p, flat(TIBIA, -0.028), flat(TIBIA, 0.028), 0.040, 0.008);
    return melt(melt(hub, beam, WELD), knee, WELD);
}

Region femurRegion(const Vector3d& p)
{
    if ((p.head<2>() - FEMUR).norm() < 0.030 && std::abs(p.z()) > 0.034) return STEEL;
    if ((p.head<2>() - FEMUR).norm() < 0.060) return DARK;
    const double part = along(p, FEMUR, TIBIA);
    return part > 0.44 && part < 0.56 ? DARK : PAINT;
}

double tibiaDistance(const Vector3d& p)
{
    const Vector2d ankle = TIBIA + 0.86 * (FOOT - TIBIA), elbow = TIBIA + 0.14 * (FOOT - TIBIA);
    const double hub = cylinderDistance(p, flat(TIBIA, -0.040), flat(TIBIA, 0.040), 0.034, 0.007);
    const double shin = bar(p, TIBIA, ankle, {0.036, 0.024}, {0.019, 0.017}, 0.009);
    const double guard = bar(p, elbow, TIBIA + 0.55 * (FOOT - TIBIA), {0.040, 0.029}, {0.030, 0.025}, 0.012);
    const double foot = limbDistance(p, {flat(ankle), flat(FOOT), 0.019, FOOT_RADIUS});
    return melt(melt(melt(hub, shin, WELD), guard, WELD), foot, WELD);
}

Region tibiaRegion(const Vector3d& p)
{
    const double part = along(p, TIBIA, FOOT);
    if ((p.head<2>() - TIBIA).norm() < 0.046) return std::abs(p.z()) > 0.033 ? STEEL : DARK;
    if (part > 0.86) return RUBBER;
    return part > 0.14 && part < 0.55 ? PAINT : part > 0.80 ? STEEL : DARK;
}

// A low hull with a seam around it.
double bodyDistance(const Vector3d& p)
{
    double d = ellipsoidDistance(p, {0, 0.318, 0}, {0.205, 0.135, 0.275});
    d = -melt(-d, -boxDistance(p, {0, 0.320, 0}, {0.19, 0.082, 0.235}, 0.060), 0.03);
    for (const SpiderLeg& leg : SPIDER_LEGS) {
        const Vector3d left(std::abs(p.x()), p.y(), p.z());
        const Vector3d arm = Vector3d::UnitY() * 0.062;
        d = melt(d, cylinderDistance(left, leg.hip - arm, leg.hip + arm, 0.040, 0.010), 0.014);
    }
    d += 0.005 * std::exp(-std::pow((p.y() - 0.318) / 0.005, 2));
    return d;
}

Region bodyRegion(const Vector3d& p)
{
    if (p.y() < 0.309) return STEEL;
    if (p.y() < 0.327) return DARK;
    const double hatch = std::hypot(p.x() / 0.092, (p.z() + 0.03) / 0.140);
    return hatch < 0.72 ? STEEL : hatch < 0.95 ? DARK : PAINT;
}

double abdomenDistance(const Vector3d& p)
{
    const double hull = ellipsoidDistance(p, {0, 0.372, -0.350}, {0.138, 0.112, 0.165});
    const double neck = cylinderDistance(p, {0, 0.345, -0.190}, {0, 0.352, -0.260}, 0.058, 0.012);
    const double d = melt(hull, neck, 0.012);
    return melt(d, limbDistance(p, {{0, 0.370, -0.500}, {0, 0.375, -0.540}, 0.026, 0.014}), 0.012);
}

Region abdomenRegion(const Vector3d& p)
{
    const double z = p.z() - 0.25 * (p.y() - 0.372);
    if (p.z() > -0.225 || p.z() < -0.512) return DARK;
    if (p.y() < 0.325) return STEEL;
    return (z > -0.300 && z < -0.268) || (z > -0.372 && z < -0.340) || (z > -0.444 && z < -0.412) ? DARK : PAINT;
}

const Vector3d EYE{0, 0.335, 0.318};
const Vector3d SIDE_EYE{0.062, 0.350, 0.292};
constexpr double EYE_RADIUS = 0.038, SIDE_EYE_RADIUS = 0.014;

double headDistance(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    double d = boxDistance(p, {0, 0.328, 0.262}, {0.085, 0.056, 0.055}, 0.032);
    d = melt(d, cylinderDistance(p, {0, 0.322, 0.180}, {0, 0.322, 0.240}, 0.050, 0.010), 0.010);
    d = melt(d, cylinderDistance(p, {0, 0.335, 0.280}, {0, 0.335, 0.334}, EYE_RADIUS + 0.010, 0.006), 0.006);
    d = melt(d, (p - EYE).norm() - EYE_RADIUS, 0.002);
    d = melt(d, (left - SIDE_EYE).norm() - SIDE_EYE_RADIUS - 0.006, 0.004);
    // Two short feelers.
    return melt(d, limbDistance(left, {{0.040, 0.288, 0.300}, {0.034, 0.255, 0.345}, 0.018, 0.010}), 0.008);
}

Region headRegion(const Vector3d& p)
{
    const Vector3d left(std::abs(p.x()), p.y(), p.z());
    const double out = std::hypot(p.x(), p.y() - EYE.y());
    if (p.z() > 0.324 && out < EYE_RADIUS - 0.003) return out < 0.013 ? LENS_CORE : out > 0.028 ? LENS_RIM : LENS;
    if (p.z() > 0.312 && out < EYE_RADIUS + 0.012) return DARK;
    if ((left - SIDE_EYE).norm() < SIDE_EYE_RADIUS + 0.0085) return left.z() > 0.304 ? LENS : DARK;
    if (p.z() < 0.215 || p.y() < 0.278) return DARK;
    return p.y() < 0.306 ? STEEL : PAINT;
}

Vector3f colorAt(Region region, const Vector3d&)
{
    switch (region) {
        case STEEL: return screenColor(176, 182, 190);
        case DARK: return screenColor(44, 48, 56);
        case RUBBER: return screenColor(26, 26, 28);
        case LENS: return screenColor(40, 196, 220);
        case LENS_RIM: return screenColor(16, 40, 52);
        case LENS_CORE: return screenColor(216, 250, 255);
        default: return screenColor(238, 168, 28);
    }
}

double coarse(const Vector3d&)
{
    return 4 * CELL;
}

// Fine at the lens.
double headCell(const Vector3d& p)
{
    return p.z() > 0.318 && std::hypot(p.x(), p.y() - EYE.y()) < 0.042 ? CELL : 2 * CELL;
}

Figure shell(uint32_t bone, const Vector3d& centre, int levels, Distance distance,
             std::function<Region(const Vector3d&)> region, std::function<double(const Vector3d&)> cellAt = coarse)
{
    Figure figure;
    figure.distance = std::move(distance);
    figure.grid = {centre, CELL, levels, std::move(cellAt)};
    figure.regionAt = std::move(region);
    figure.colorAt = colorAt;
    figure.weightsAt = [bone](Region, const Vector3d&) { return SkinWeights{{bone}, {1.0f}}; };
    return figure;
}

}  // namespace

std::vector<Figure> spiderFigures(const Skeleton& skeleton)
{
    std::vector<Figure> all;
    const auto bone = [&](const char* name) { return boneIndex(skeleton, name); };
    all.push_back(shell(bone("body"), {0, 0.32, 0}, 8, bodyDistance, bodyRegion));
    all.push_back(shell(bone("abdomen"), {0, 0.37, -0.35}, 8, abdomenDistance, abdomenRegion));
    all.push_back(shell(bone("head"), {0, 0.33, 0.27}, 7, headDistance, headRegion, headCell));
    struct Segment {
        Vector2d from, to;
        double (*distance)(const Vector3d&);
        Region (*region)(const Vector3d&);
    };
    const Segment segments[] = {{{0, 0}, FEMUR, coxaDistance, coxaRegion},
                                {FEMUR, TIBIA, femurDistance, femurRegion},
                                {TIBIA, FOOT, tibiaDistance, tibiaRegion}};
    for (const SpiderLeg& leg : SPIDER_LEGS) {
        for (uint32_t i = 0; i < 6; ++i) {
            const Segment& segment = segments[i % 3];
            const InLeg local{&leg, i >= 3};
            Vector3d centre = inLeg(leg, 0.5 * (segment.from + segment.to));
            if (local.mirror) centre.x() *= -1;
            all.push_back(shell(
                bone(leg.bones[0]) + i, centre, 8, [=](const Vector3d& p) { return segment.distance(local(p)); },
                [=](const Vector3d& p) { return segment.region(local(p)); }));
        }
    }
    return all;
}

}  // namespace knuckle
