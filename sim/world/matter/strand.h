#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace knuckle {

struct World;

/// The purpose of a strand's distances.
enum class DistanceKind : uint32_t {
    Stretch,  ///< Between neighbours: the threads of a rope or a piece of cloth. At most a diameter each.
    Shear,    ///< Across the cells of a cloth.
    Bend,     ///< Between second neighbours.
};

/// Particles in a row, each held at a distance from the next (XPBD, Macklin et al. 2016) and solved together. A rope is
/// one strand, cloth is many that cross. Particles are loose or of one body.
struct Strand {
    DistanceKind kind = DistanceKind::Stretch;
    std::vector<uint32_t> particles;  ///< At least two, none twice.
    std::vector<float> restLengths;   ///< To the next particle, one less than those [m], > 0.
    float compliance = 0.0f;          ///< Of each distance [m/N], >= 0; 0: rigid.
    /// Tension at which a distance breaks for good [N], > 0. If finite, distances of Shear and Bend also break at one
    /// and a half times their length: they are soft, and would keep torn pieces together.
    float tearForce = std::numeric_limits<float>::infinity();
    /// When it lets go of its first and of its last particle for good [s], > 0.
    float startRelease = std::numeric_limits<float>::infinity();
    float endRelease = std::numeric_limits<float>::infinity();

    bool letsGo() const { return std::min(startRelease, endRelease) < std::numeric_limits<float>::infinity(); }
};

/// Particle::selfMargin for strands: neighbours are a diameter apart and must not touch each other.
inline constexpr float ROPE_MARGIN = 0.1f;

/// Makes one assembly of everything that strands connect, so that particles nearer than a diameter at the start do not
/// touch each other, and velocities have the same order throughout. The world's start becomes the rest pose.
void joinStrandAssemblies(World& world);

/// Validates strands.
void validateStrands(const World& world);

}  // namespace knuckle
