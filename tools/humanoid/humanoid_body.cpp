#include <algorithm>
#include <cmath>
#include <span>

#include "tools/humanoid/humanoid_look.h"

namespace knuckle {

using Eigen::Vector3d;

namespace {

constexpr double BLEND = 0.035;  // width over which limbs blend into each other [m]

// The left half of the body and the parts in the middle.
const Limb LIMBS[] = {
    {{0, 0.95, -0.005}, {0.065, 0.95, -0.005}, 0.100, 0.092},       // pelvis
    {{0.062, 0.915, -0.045}, {0.075, 0.90, -0.045}, 0.075, 0.072},  // seat
    {{0, 1.08, 0.0}, {0.045, 1.08, 0.0}, 0.092, 0.080},             // waist
    {{0.03, 0.98, -0.005}, {0.045, 1.30, -0.005}, 0.090, 0.094},    // trunk
    {{0, 1.27, -0.005}, {0.072, 1.29, -0.005}, 0.105, 0.095},       // ribs
    {{0.06, 1.335, 0.02}, {0.085, 1.33, 0.015}, 0.066, 0.062},      // breast
    {{0, 1.40, -0.015}, {0.15, 1.405, -0.012}, 0.062, 0.052},       // shoulders
    {{0.175, 1.40, -0.01}, {0.19, 1.385, -0.01}, 0.060, 0.058},     // deltoid
    {{0, 1.43, -0.015}, {0, 1.55, 0.0}, 0.058, 0.052},              // neck
    {{0.195, 1.39, -0.01}, {0.365, 1.195, -0.012}, 0.055, 0.042},
    {{0.365, 1.195, -0.012}, {0.43, 1.12, -0.002}, 0.043, 0.043},
    {{0.43, 1.12, -0.002}, {0.528, 1.005, 0.014}, 0.043, 0.029},
    {{0.095, 0.90, 0.0}, {0.119, 0.50, 0.01}, 0.086, 0.056},      // thigh
    {{0.119, 0.50, 0.012}, {0.124, 0.36, -0.012}, 0.055, 0.057},  // calf
    {{0.124, 0.36, -0.012}, {0.133, 0.085, -0.025}, 0.056, 0.038},
    {{0.133, 0.04, -0.055}, {0.135, 0.05, 0.0}, 0.040, 0.044},  // heel
    {{0.135, 0.05, 0.0}, {0.158, 0.022, 0.135}, 0.046, 0.030},  // foot
};

const Limb PALM[] = {
    {{0.535, 0.995, 0.016}, {0.58, 0.94, 0.028}, 0.030, 0.031},
    {{0.562, 0.95, 0.047}, {0.575, 0.935, 0.002}, 0.025, 0.023},
};
constexpr double PALM_BLEND = 0.02, FINGER_BLEND = 0.005;  // [m]

struct Finger {
    double z, length, spread;  // its start, its length, and how far its tip goes along z [m]
};
const Finger FINGERS[] = {
    {0.054, 0.074, 0.008}, {0.034, 0.082, 0.002}, {0.014, 0.077, -0.003}, {-0.005, 0.062, -0.008}};
const Limb THUMB[] = {
    {{0.545, 0.972, 0.045}, {0.567, 0.944, 0.078}, 0.019, 0.0135},
    {{0.567, 0.944, 0.078}, {0.588, 0.912, 0.090}, 0.0135, 0.0105},
};
const Vector3d HAND_CENTRE{0.585, 0.925, 0.035};
constexpr double HAND_REACH = 0.115;  // [m]

// Distances to hems along the body [m], negative within the cloth.
struct Hems {
    double collar, sleeve, waist, belt, trousers, shoe;
};

Hems hemsAt(const Vector3d& p)
{
    const Vector3d onForearm = p - Vector3d(0.396, 1.160, -0.006), forearm(0.649, -0.754, 0.10);
    // The collar is a cone about the neck, lower in front.
    const double aroundNeck = Vector3d(p.x(), 0, p.z() + 0.008).norm();
    return {p.y() - 1.430 + 0.25 * p.z() - 1.2 * (aroundNeck - 0.066),
            p.x() > 0.22 ? onForearm.dot(forearm) : -1.0,
            p.x() < 0.3 ? 1.008 - p.y() : -1.0,
            p.x() < 0.3 ? 0.974 - p.y() : -1.0,
            0.118 - p.y(),
            p.y() - 0.084 + 0.12 * p.z()};
}

constexpr double COLLAR = 0.016, SLEEVE_BAND = 0.02, CUFF_HEIGHT = 0.034, SOLE_HEIGHT = 0.020;  // [m]

// From 0 before a hem to 1 beyond it.
double behind(double hem)
{
    return std::clamp(0.5 - hem / 0.006, 0.0, 1.0);
}

double between(double hem, double width)
{
    return behind(hem) * (1.0 - behind(hem + width));
}

// How far clothes stand out from the limbs; bare skin lies a little deeper [m].
double thickness(const Vector3d& p)
{
    const Hems hem = hemsAt(p);
    const double shirt = behind(hem.collar) * behind(hem.sleeve) * behind(hem.waist);
    const double bands = std::max(between(hem.collar, COLLAR), between(hem.sleeve, SLEEVE_BAND)) * behind(hem.waist);
    const double belt = behind(hem.belt) * (1.0 - behind(hem.waist));
    const double buckle = belt * behind(std::max(p.x() - 0.022, -p.z()));
    const double trousers = behind(hem.trousers) * (1.0 - behind(hem.belt));
    const double cuff = between(hem.trousers, CUFF_HEIGHT);
    const double shoe = behind(hem.shoe), sole = behind(p.y() - SOLE_HEIGHT);
    return -0.002 + 0.002 * shirt + 0.002 * bands + 0.0045 * belt + 0.003 * buckle + 0.0015 * trousers + 0.004 * cuff +
           0.002 * shoe + 0.003 * sole;
}

bool isLace(const Vector3d& p)
{
    const double along = (p.z() - 0.022) / 0.021, middle = 0.136 + 0.12 * p.z();
    return along > 0.0 && along < 3.6 && along - std::floor(along) < 0.45 && std::abs(p.x() - middle) < 0.021 &&
           p.y() > 0.05;
}

}  // namespace

double bodyDistance(const Vector3d& p)
{
    double distance = limbDistance(p, LIMBS[0]);
    for (const Limb& limb : std::span(LIMBS).subspan(1)) distance = melt(distance, limbDistance(p, limb), BLEND);
    return distance - thickness(p);
}

HumanoidRegion clothesAt(const Vector3d& p)
{
    const Hems hem = hemsAt(p);
    if (p.y() > 1.6 || hem.sleeve > 0.0 || hem.collar > 0.0) return BODY_SKIN;
    if (hem.waist < 0.0) {
        // Raglan sleeves: from the collar to the armpit.
        const bool sleeve = p.x() > 0.058 + 0.40 * std::max(1.475 - p.y(), 0.0) && p.y() > 1.08;
        return sleeve || hem.collar > -COLLAR ? SLEEVE : SHIRT;
    }
    if (hem.belt < 0.0) return p.x() < 0.022 && p.z() > 0.0 ? BUCKLE : BELT;
    if (hem.trousers < -CUFF_HEIGHT) return TROUSERS;
    if (hem.trousers < 0.0) return CUFF;
    if (hem.shoe > 0.0) return SOCK;
    if (p.y() < SOLE_HEIGHT || p.z() > 0.128) return SOLE;
    return isLace(p) ? LACE : SHOE;
}

double hemDistance(const Vector3d& p)
{
    const Hems hem = hemsAt(p);
    double nearest = 1.0;
    for (const double h : {hem.collar, hem.collar + COLLAR, hem.sleeve, hem.sleeve + SLEEVE_BAND, hem.waist, hem.belt,
                           hem.trousers, hem.trousers + CUFF_HEIGHT, hem.shoe})
        nearest = std::min(nearest, std::abs(h));
    return nearest;
}

double handDistance(const Vector3d& p)
{
    const double outside = (p - HAND_CENTRE).norm() - HAND_REACH;
    if (outside > BLEND) return outside;
    double palm = limbDistance(p, PALM[0]);
    palm = melt(palm, limbDistance(p, PALM[1]), PALM_BLEND);
    for (const Limb& limb : THUMB) palm = melt(palm, limbDistance(p, limb), 0.012);
    double fingers = 1.0;
    const Vector3d straight(0.58, -0.81, 0.0), curled(0.30, -0.954, 0.0);
    for (const Finger& finger : FINGERS) {
        const Vector3d base(0.578, 0.937, finger.z), along(0, 0, 0.5 * finger.spread);
        const Vector3d middle = base + (0.022 + 0.5 * finger.length) * straight + along;
        const Vector3d tip = middle + 0.5 * finger.length * curled + along;
        fingers = melt(fingers, limbDistance(p, {base, middle, 0.0115, 0.0100}), FINGER_BLEND);
        fingers = melt(fingers, limbDistance(p, {middle, tip, 0.0100, 0.0082}), FINGER_BLEND);
    }
    return melt(palm, fingers, 0.010);
}

}  // namespace knuckle
