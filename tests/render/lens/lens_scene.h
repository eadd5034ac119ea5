#pragma once

#include <cmath>

#include "tests/render/render_fixture.h"

namespace knuckle::test {

inline constexpr uint32_t SIZE = 128;

inline double lightOf(uint8_t shown)
{
    const double v = shown / 255.0;
    return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

/// Evenly lit, on nothing, with a curve that can be undone.
inline RenderSettings evenly(const Vector3f& position, const Vector3f& target = Vector3f::Zero())
{
    RenderSettings settings = lookFrom(position, target, SIZE, SIZE);
    settings.light.intensity = 0.0f;
    settings.light.skyColor = settings.light.groundColor = {1, 1, 1};
    settings.background = Background::Color;
    settings.toneMap = ToneMap::Linear;
    return settings;
}

inline StillWorld ball(const Vector3f& place, float radius)
{
    StillWorld still(0.05f);
    Collider& collider = still.addCollider(ColliderShape::Sphere, place);
    collider.radius = radius;
    collider.color = {1, 1, 1};
    return still;
}

/// Moments of the light of a picture, in pixels.
struct Spread {
    double sum = 0.0, x = 0.0, y = 0.0;
    double square = 0.0;  ///< Mean squared distance from (x, y).
};

inline Spread spreadOf(const Image& image)
{
    Spread spread;
    double squares = 0.0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double light = lightOf(static_cast<uint8_t>(pixelAt(image, x, y).y()));
            spread.sum += light;
            spread.x += light * x;
            spread.y += light * y;
            squares += light * (double(x) * x + double(y) * y);
        }
    spread.x /= spread.sum;
    spread.y /= spread.sum;
    spread.square = squares / spread.sum - spread.x * spread.x - spread.y * spread.y;
    return spread;
}

}  // namespace knuckle::test
