#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tools/dog/dog_parts.h"

namespace knuckle {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

enum DogRegion : Region { GINGER, CREAM, EYE, EYE_RIM, PUPIL, NOSE, MOUTH, INNER_EAR, COLLAR, TAG };

constexpr double FINEST_CELL = 0.0020;  // of the mesh, at the eyes [m]

struct Group {
    std::vector<Limb> limbs;
    double blend;  // within the group [m]
};

// The left half and the parts in the middle.
const Group TRUNK{{{{0, 0.500, 0.140}, {0, 0.515, 0.050}, 0.132, 0.122},            // ribs
                   {{0, 0.515, 0.050}, {0, 0.530, -0.110}, 0.120, 0.095},           // belly
                   {{0, 0.530, -0.110}, {0, 0.525, -0.250}, 0.096, 0.092},          // loin
                   {{0, 0.470, 0.200}, {0, 0.520, 0.235}, 0.098, 0.085},            // breast
                   {{0.045, 0.510, -0.255}, {0.050, 0.500, -0.260}, 0.085, 0.080},  // rump
                   {{0, 0.560, 0.215}, {0, 0.690, 0.355}, 0.094, 0.074}},           // neck
                  0.05};
const Group LEGS{{{{0.055, 0.555, 0.185}, {0.075, 0.440, 0.262}, 0.056, 0.052},  // shoulder
                  {{0.078, 0.445, 0.262}, {0.085, 0.325, 0.188}, 0.056, 0.042},
                  {{0.085, 0.325, 0.186}, {0.085, 0.200, 0.195}, 0.041, 0.032},
                  {{0.085, 0.200, 0.195}, {0.085, 0.085, 0.203}, 0.032, 0.030},
                  {{0.085, 0.085, 0.203}, {0.086, 0.034, 0.222}, 0.030, 0.032},
                  {{0.072, 0.500, -0.240}, {0.088, 0.345, -0.195}, 0.088, 0.056},  // thigh
                  {{0.088, 0.345, -0.195}, {0.089, 0.195, -0.300}, 0.052, 0.030},
                  {{0.089, 0.195, -0.304}, {0.088, 0.060, -0.284}, 0.030, 0.028},
                  {{0.088, 0.060, -0.284}, {0.089, 0.034, -0.262}, 0.028, 0.032}},
                 0.03};
const Group TAIL{{{{0, 0.560, -0.310}, {0, 0.600, -0.405}, 0.038, 0.046},
                  {{0, 0.600, -0.405}, {0, 0.660, -0.472}, 0.046, 0.052},
                  {{0, 0.660, -0.472}, {0, 0.735, -0.512}, 0.052, 0.036},
                  {{0, 0.735, -0.512}, {0, 0.785, -0.510}, 0.036, 0.012}},
                 0.03};
const Group HEAD{{{{0, 0.735, 0.385}, {0, 0.735, 0.405}, 0.076, 0.074},           // skull
                  {{0.038, 0.700, 0.395}, {0.040, 0.700, 0.420}, 0.050, 0.044},   // cheek
                  {{0, 0.706, 0.455}, {0.008, 0.700, 0.530}, 0.047, 0.030},       // muzzle
                  {{0, 0.676, 0.430}, {0.004, 0.672, 0.512}, 0.032, 0.020},       // jaw
                  {{0.028, 0.755, 0.440}, {0.034, 0.752, 0.436}, 0.024, 0.022}},  // brow
                 0.03};
// Toes of the front paw; those of the back paw are BACK_PAW further back.
const Limb TOES[] = {{{0.069, 0.026, 0.226}, {0.066, 0.019, 0.244}, 0.018, 0.0165},
                     {{0.080, 0.026, 0.232}, {0.079, 0.018, 0.256}, 0.018, 0.0165},
                     {{0.094, 0.026, 0.232}, {0.095, 0.018, 0.256}, 0.018, 0.0165},
                     {{0.105, 0.026, 0.226}, {0.108, 0.019, 0.244}, 0.018, 0.0165}};
const Vector3d BACK_PAW{0.002, 0, -0.482};

const Vector3d EYE_CENTRE{0.037, 0.742, 0.468};
constexpr double EYE_RADIUS = 0.0150;
const Vector3d NOSE_TIP{0, 0.714, 0.555};
const Vector3d EAR_BASE{0.047, 0.775, 0.378}, EAR_TIP{0.064, 0.858, 0.376}, EAR_FRONT{0.22, 0.10, 0.97};
const Vector3d NECK_AXIS = Vector3d(0, 0.130, 0.140).normalized(), COLLAR_CENTRE{0, 0.628, 0.294};
constexpr double COLLAR_WIDTH = 0.024;  // [m]
const Vector3d TAG_CENTRE{0, 0.556, 0.362};

Vector3d leftOf(const Vector3d& p)
{
    return {std::abs(p.x()), p.y(), p.z()};
}

double groupDistance(const Vector3d& p, const Group& group)
{
    double d = limbDistance(p, group.limbs.front());
    for (const Limb& limb : std::span(group.limbs).subspan(1)) d = melt(d, limbDistance(p, limb), group.blend);
    return d;
}

// A cone, flat from front to back and hollow in front.
double earDistance(const Vector3d& p)
{
    const double t = segmentParameter(p, EAR_BASE, EAR_TIP);
    Vector3d off = p - EAR_BASE - t * (EAR_TIP - EAR_BASE);
    const Vector3d front = EAR_FRONT.normalized();
    const double deep = off.dot(front);
    off += 0.8 * deep * front;
    const double ear = 0.55 * (off.norm() - (0.038 * std::sqrt(1.0 - t) + 0.007));
    const double hollow = limbDistance(p, {EAR_BASE + 0.022 * front, EAR_TIP + 0.012 * front, 0.024, 0.006});
    return -melt(-ear, hollow, 0.006);
}

double collarAt(const Vector3d& p)
{
    return (p - COLLAR_CENTRE).dot(NECK_AXIS);
}

double pawDistance(const Vector3d& p)
{
    double paw = 1.0;
    for (const Limb& toe : TOES)
        paw = melt(paw, std::min(limbDistance(p, toe), limbDistance(p - BACK_PAW, toe)), 0.006);
    return paw;
}

constexpr double MOUTH_END = 0.468;  // [m]

double mouthLine(const Vector3d& p)
{
    return p.z() > MOUTH_END ? std::abs(p.y() - 0.6835 + 0.06 * (p.z() - 0.5)) : 1.0;
}

double distanceAt(const Vector3d& point)
{
    const Vector3d p = leftOf(point);
    double d = melt(groupDistance(p, TRUNK), groupDistance(p, LEGS), 0.035);
    d = melt(d, pawDistance(p), 0.012);
    d = melt(d, groupDistance(p, TAIL), 0.03);
    if ((p - Vector3d(0, 0.74, 0.42)).norm() - 0.22 < std::max(d, 0.0) + 0.04) {
        d = melt(d, groupDistance(p, HEAD), 0.035);
        d = melt(d, earDistance(p), 0.016);
        d = melt(d, (p - EYE_CENTRE).norm() - EYE_RADIUS, 0.006);
        d = melt(d, ellipsoidDistance(p, NOSE_TIP, {0.018, 0.013, 0.014}), 0.006);
        d += 0.0025 * std::exp(-std::pow(mouthLine(p) / 0.0022, 2));
    }
    // The collar lies on the fur.
    const double ring = std::abs(collarAt(p));
    d -= 0.004 * std::clamp((COLLAR_WIDTH / 2 - ring) / 0.003 + 0.5, 0.0, 1.0) * (p.y() > 0.5 && p.z() > 0.15 ? 1 : 0);
    d = melt(d, ellipsoidDistance(p, TAG_CENTRE, {0.015, 0.017, 0.006}), 0.002);
    return std::max(d, -p.y());
}

double cellAt(const Vector3d& point)
{
    const Vector3d p = leftOf(point);
    if ((p - EYE_CENTRE - Vector3d(0.004, 0, 0.008)).norm() < 0.016) return FINEST_CELL;
    if (mouthLine(p) < 0.008 || (p - NOSE_TIP).norm() < 0.03 || (p - TAG_CENTRE).norm() < 0.024)
        return 2.0 * FINEST_CELL;
    const bool head = p.y() > 0.64 && p.z() > 0.30, paw = p.y() < 0.05;
    const bool collar = std::abs(collarAt(p)) < 0.022 && p.z() > 0.15 && p.y() > 0.5;
    return head || paw || collar ? 4.0 * FINEST_CELL : 8.0 * FINEST_CELL;
}

double soft(double value, double width)
{
    return 0.5 + 0.5 * std::clamp(value / width, -1.0, 1.0);
}

// Cream below, on the face, the paws and the tip of the tail.
bool isCream(const Vector3d& p)
{
    const double belly = soft(0.445 - p.y() - 0.25 * std::max(p.z() - 0.1, 0.0), 0.04) *
                         soft(0.080 - p.x() + 0.25 * std::max(p.z() - 0.15, 0.0), 0.035);
    const double breast = soft(p.z() - 0.245 - 0.35 * std::max(p.y() - 0.48, 0.0), 0.03) * soft(0.68 - p.y(), 0.05) *
                          soft(0.06 - p.x(), 0.035);
    const double socks = soft(0.115 - p.y(), 0.025);
    const double muzzle = soft(0.712 - 0.26 * std::max(p.z() - 0.50, 0.0) - p.y() + 0.30 * (p.x() - 0.012), 0.012) *
                          soft(p.z() - 0.385, 0.03) * soft(p.y() - 0.62, 0.03);
    const double brow = soft(0.011 - (p - Vector3d(0.027, 0.768, 0.452)).norm(), 0.006);
    const double tip = std::max(soft(p.y() - 0.735, 0.02) * soft(-0.40 - p.z(), 0.02),
                                soft(-0.492 - p.z() - 0.3 * (p.y() - 0.68), 0.012));
    return std::max({belly, breast, socks, muzzle, brow, tip}) > 0.5;
}

Region regionAt(const Vector3d& point)
{
    const Vector3d p = leftOf(point);
    const double eye = (p - EYE_CENTRE).norm();
    if (eye < EYE_RADIUS + 0.0030 && p.z() > EYE_CENTRE.z() - 0.004) {
        const Vector3d gaze = Vector3d(0.35, 0.02, 0.94).normalized();
        const double off = (p - EYE_CENTRE).cross(gaze).norm();
        if (off < 0.0062) return PUPIL;
        if (off < 0.0105) return EYE;
        if (off < 0.0135) return EYE_RIM;
    }
    if ((p - NOSE_TIP).cwiseQuotient(Vector3d(0.018, 0.013, 0.014)).norm() < 1.12) return NOSE;
    if (mouthLine(p) < 0.0022) return MOUTH;
    const Vector3d front = EAR_FRONT.normalized();
    if (p.y() > 0.795 && limbDistance(p, {EAR_BASE + 0.022 * front, EAR_TIP + 0.012 * front, 0.0255, 0.0070}) < 0.0)
        return INNER_EAR;
    if (ellipsoidDistance(p, TAG_CENTRE, {0.015, 0.017, 0.006}) < 0.001) return TAG;
    if (std::abs(collarAt(p)) < COLLAR_WIDTH / 2 && p.z() > 0.15 && p.y() > 0.5) return COLLAR;
    return isCream(p) ? CREAM : GINGER;
}

// A darker saddle.
Vector3f gingerAt(const Vector3d& p)
{
    const double saddle = soft(p.y() - 0.585 + 0.08 * std::max(p.z(), 0.0), 0.07) * soft(0.25 - p.z(), 0.07) *
                          soft(p.z() + 0.33, 0.07);
    const Vector3f light = screenColor(206, 118, 54), dark = screenColor(128, 66, 34);
    return light + static_cast<float>(0.75 * saddle) * (dark - light);
}

Vector3f colorAt(Region region, const Vector3d& p)
{
    switch (region) {
        case CREAM: return screenColor(240, 224, 198);
        case EYE: return screenColor(92, 52, 24);
        case EYE_RIM: return screenColor(40, 26, 22);
        case PUPIL: return screenColor(12, 10, 12);
        case NOSE: return screenColor(28, 24, 26);
        case MOUTH: return screenColor(58, 34, 32);
        case INNER_EAR: return screenColor(226, 176, 150);
        case COLLAR: return screenColor(24, 112, 128);
        case TAG: return screenColor(222, 180, 92);
        default: return gingerAt(p);
    }
}

}  // namespace

Figure dogFigure(const Skeleton& skeleton)
{
    Figure figure;
    figure.distance = distanceAt;
    figure.grid = {{0, 256 * FINEST_CELL, 0}, FINEST_CELL, 10, cellAt};  // y = 0 between cells
    figure.regionAt = regionAt;
    figure.colorAt = colorAt;
    figure.weightsAt = [skeleton](Region, const Vector3d& p) { return weightsAt(skeleton, p); };
    return figure;
}

}  // namespace knuckle
