#pragma once

#include <vector>

#include "tests/render/render_fixture.h"

namespace knuckle::test {

constexpr uint32_t PICTURE = 200;  // [pixels] a side

/// A particle of no body, of the first material, which is red as the sky is not.
inline StillWorld redMatter(float radius)
{
    StillWorld still(radius);
    still.world.materials[0].color = {0.9f, 0.02f, 0.02f};
    return still;
}

inline uint32_t addLoose(World& world, const Vector3f& position)
{
    Particle particle;
    particle.position = particle.restPosition = position;
    world.particles.push_back(particle);
    return static_cast<uint32_t>(world.particles.size()) - 1;
}

/// A strand through particles, whose links may break.
inline void addStrand(World& world, const std::vector<uint32_t>& particles, float link)
{
    Strand strand;
    strand.particles = particles;
    strand.restLengths.assign(particles.size() - 1, link);
    strand.tearForce = 1.0f;
    world.strands.push_back(strand);
}

inline RenderSettings redView(const Vector3f& eye)
{
    RenderSettings settings = lookFrom(eye, {0, 0, 0}, PICTURE, PICTURE);
    settings.colorBy = ColorBy::Material;
    return settings;
}

inline bool isRed(const Image& image, uint32_t x, uint32_t y)
{
    const Eigen::Vector3i color = pixelAt(image, x, y);
    return color.x() - color.z() > 30;
}

inline uint32_t redPixels(const Image& image)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PICTURE * PICTURE; ++i) count += isRed(image, i % PICTURE, i / PICTURE);
    return count;
}

/// Red pixels of a row, or of a column.
inline uint32_t redIn(const Image& image, uint32_t line, bool row)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PICTURE; ++i) count += row ? isRed(image, i, line) : isRed(image, line, i);
    return count;
}

/// Pixels that a length takes at a distance from the eye; the field of view is 40 degrees.
inline float pixelsOf(float length, float distance)
{
    return length * PICTURE / (2.0f * distance * std::tan(20.0f * 3.14159265f / 180.0f));
}

/// Whether the middle of the picture is dark blue at rest and bright when all particles are fast.
void expectColorsBySpeed(World world, float distance);

/// The picture of `world` with some of its distances torn, by their index in the solver's order.
Image drawnTorn(const World& world, const RenderSettings& settings, const std::vector<size_t>& torn);

}  // namespace knuckle::test
