#pragma once

#include "tools/shapes/figure.h"
#include "tools/shapes/skeleton.h"

/// The humanoid's surface: body, head and hands melted into one, clothes raised above it. All of it but the hair
/// mirrors x.
namespace knuckle {

/// What the figure's surface is, region by region.
enum HumanoidRegion : Region {
    BODY_SKIN,
    LIPS,
    MOUTH,
    EYE_WHITE,
    IRIS,
    PUPIL,
    LASHES,
    BROW,
    HAIR,
    SHIRT,
    SLEEVE,
    BELT,
    BUCKLE,
    TROUSERS,
    CUFF,
    SOCK,
    SHOE,
    LACE,
    SOLE,
};

/// The body with clothes, without hands, and head but for the skull. @param p of the left side (x >= 0).
double bodyDistance(const Eigen::Vector3d& p);
/// SHIRT and on, or BODY_SKIN where nothing is worn.
HumanoidRegion clothesAt(const Eigen::Vector3d& p);
/// How near to a hem, where the mesh has to be fine [m].
double hemDistance(const Eigen::Vector3d& p);

double handDistance(const Eigen::Vector3d& p);

/// Melts the face to `body` and lays the hair over it. @param p of either side: the parting is on the left.
double headDistance(const Eigen::Vector3d& p, double body);
/// BODY_SKIN to HAIR.
HumanoidRegion headRegionAt(const Eigen::Vector3d& p);
/// How near to an eye or the mouth [m].
double featureDistance(const Eigen::Vector3d& p);

/// All of it, for the skeleton of makeHumanoid().
Figure humanoidFigure(const Skeleton& skeleton);

}  // namespace knuckle
