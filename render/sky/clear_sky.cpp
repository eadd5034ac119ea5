#include "render/sky/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double PI = std::numbers::pi;
constexpr uint32_t WIDTH = 256, HEIGHT = 128;
/// Luminance of LightSettings' sky.
constexpr float BRIGHTNESS = 0.668f;
/// Of the ground below the horizon.
constexpr float GROUND_ALBEDO = 0.35f;

/// The paper's A ... E of x, y and Y, each a turbidity's factor and what is added.
constexpr double DISTRIBUTION[3][5][2] = {
    {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}},
    {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}},
    {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}},
};
/// Of x and y straight up: by powers of turbidity, then of the sun's angle, highest first.
constexpr double ZENITH[2][3][4] = {
    {{0.00166, -0.00375, 0.00209, 0.0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}},
    {{0.00275, -0.00610, 0.00317, 0.0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}},
};

double zenithChromaticity(int which, double turbidity, double angle)
{
    double sum = 0.0;
    for (const auto& row : ZENITH[which]) {
        double part = 0.0;
        for (const double factor : row) part = part * angle + factor;
        sum = sum * turbidity + part;
    }
    return sum;
}

/// Perez's distribution. @param cosine of the angle from the zenith. @param gamma from the sun [rad].
double perez(int which, double turbidity, double cosine, double gamma)
{
    double c[5];
    for (int k = 0; k < 5; ++k) c[k] = DISTRIBUTION[which][k][0] * turbidity + DISTRIBUTION[which][k][1];
    const double near = std::cos(gamma);
    return (1.0 + c[0] * std::exp(c[1] / cosine)) * (1.0 + c[2] * std::exp(c[3] * gamma) + c[4] * near * near);
}

Vector3f rgbOf(const Vector3d& xyY)
{
    const double X = xyY.x() / xyY.y() * xyY.z(), Y = xyY.z(), Z = (1.0 - xyY.x() - xyY.y()) / xyY.y() * xyY.z();
    const Vector3d rgb(3.2406 * X - 1.5372 * Y - 0.4986 * Z, -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
                       0.0557 * X - 0.2040 * Y + 1.0570 * Z);
    return rgb.cwiseMax(0.0).cast<float>();
}

float luminance(const Vector3f& rgb)
{
    return rgb.dot(Vector3f(0.2126f, 0.7152f, 0.0722f));
}

/// Between the horizon's light and the ground's.
void addGround(SkyMap& map, const Vector3f& ground)
{
    const uint32_t horizon = map.height / 2 - 1;
    for (uint32_t row = map.height / 2; row < map.height; ++row)
        for (uint32_t column = 0; column < map.width; ++column) {
            const float low = -map.direction(column, row).y(), share = low / (low + 0.1f);
            map.radiance.push_back((1.0f - share) * map.at(column, horizon) + share * ground);
        }
}

}  // namespace

ClearSky::ClearSky(const Vector3f& sun, double turbidity)
    : sun_(sun.cast<double>()), turbidity_(turbidity), sunAngle_(std::acos(std::clamp(sun_.y(), -1.0, 1.0)))
{
    const double chi = (4.0 / 9.0 - turbidity / 120.0) * (PI - 2.0 * sunAngle_);
    zenith_ = {zenithChromaticity(0, turbidity, sunAngle_), zenithChromaticity(1, turbidity, sunAngle_),
               (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192};
}

Vector3d ClearSky::towards(const Vector3d& way) const
{
    const double cosine = std::max(way.y(), 0.01), gamma = std::acos(std::clamp(way.dot(sun_), -1.0, 1.0));
    Vector3d out;
    for (int k = 0; k < 3; ++k)
        out[k] = zenith_[k] * perez(k, turbidity_, cosine, gamma) / perez(k, turbidity_, 1.0, sunAngle_);
    return out;
}

Vector3f ClearSky::sunColor() const
{
    constexpr double WAVES[3] = {0.61, 0.55, 0.465};  // [um]
    const double mass = 1.0 / (std::cos(sunAngle_) + 0.15 * std::pow(93.885 - sunAngle_ * 180.0 / PI, -1.253));
    const double haze = 0.04608365822050 * turbidity_ - 0.04586025928522;
    Vector3f left;
    for (int k = 0; k < 3; ++k) {
        const double molecules = 0.008735 * std::pow(WAVES[k], -4.08), drops = haze * std::pow(WAVES[k], -1.3);
        left[k] = static_cast<float>(std::exp(-mass * (molecules + drops)));
    }
    return left / left.maxCoeff();
}

SkyMap ClearSky::map() const
{
    SkyMap map{WIDTH, HEIGHT, {}};
    for (uint32_t row = 0; row < HEIGHT / 2; ++row)
        for (uint32_t column = 0; column < WIDTH; ++column)
            map.radiance.push_back(rgbOf(towards(map.direction(column, row).cast<double>())));
    SkyMap whole = map;
    addGround(whole, Vector3f::Zero());
    const Vector3f mean = whole.meanOf(true);
    addGround(map, GROUND_ALBEDO * mean);
    for (Vector3f& light : map.radiance) light *= BRIGHTNESS / luminance(mean);
    return map;
}

}  // namespace knuckle
