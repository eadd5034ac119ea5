#pragma once

#include "tools/shapes/figure.h"
#include "tools/shapes/skeleton.h"

/// The humanoid's surface: body, head and hands blended into one, clothes raised above it. All of it except the hair is
/// symmetric in x.
namespace knuckle {

/// Regions of the figure's surface.
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

/// The body with clothes, without hands, and the head without the skull. @param p of the left side (x >= 0).
double bodyDistance(const Eigen::Vector3d& p);
/// SHIRT and on, or BODY_SKIN without clothes.
HumanoidRegion clothesAt(const Eigen::Vector3d& p);
/// Distance to a hem, where the mesh has to be fine [m].
double hemDistance(const Eigen::Vector3d& p);

double handDistance(const Eigen::Vector3d& p);

/// Blends the face into `body` and lays the hair over it. @param p of either side: the parting is on the left.
double headDistance(const Eigen::Vector3d& p, double body);
/// BODY_SKIN to HAIR.
HumanoidRegion headRegionAt(const Eigen::Vector3d& p);
/// Distance to an eye or the mouth [m].
double featureDistance(const Eigen::Vector3d& p);

/// All of it, for the skeleton of makeHumanoid().
Figure humanoidFigure(const Skeleton& skeleton);

}  // namespace knuckle
