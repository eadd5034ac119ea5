#pragma once

#include <Eigen/Core>
#include <memory>

#include "render/sky/sky_map.h"

namespace knuckle {

/// The light of a cloudless sky (A. J. Preetham, P. Shirley and B. Smits, "A Practical Analytic Model for Daylight",
/// 1999).
class ClearSky {
public:
    /// @param sun towards it, unit, y > 0. @param turbidity 2: very clear ... 10: hazy.
    ClearSky(const Eigen::Vector3f& sun, double turbidity);

    /// Chromaticities x and y (CIE), and luminance Y [kcd/m2], straight up.
    Eigen::Vector3d zenith() const { return zenith_; }
    /// The same towards a unit direction, at least a little above the horizon.
    Eigen::Vector3d towards(const Eigen::Vector3d& way) const;
    /// What the air leaves of the sun's light, the largest part 1.
    Eigen::Vector3f sunColor() const;
    /// Linear RGB, as bright on the mean as the gradient is by default; below the horizon, pale ground.
    SkyMap map() const;

private:
    Eigen::Vector3d sun_;
    double turbidity_, sunAngle_;  ///< From the zenith [rad].
    Eigen::Vector3d zenith_;
};

}  // namespace knuckle
