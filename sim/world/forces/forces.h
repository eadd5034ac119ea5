#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/world/space/region.h"

namespace knuckle {

/// The air, which moves and drags at everything that moves through it.
struct Wind {
    Eigen::Vector3f velocity{0, 0, 0};  ///< The mean [m/s].
    float density = 1.2f;               ///< Of the air [kg/m3], >= 0.
    float gusts = 0.3f;                 ///< Root mean square of the deviation from the mean velocity, over the size of
                                        ///< the mean, 0 ... 2 (turbulence intensity).
    float gustSize = 1.5f;              ///< The longest wave of gusts [m], > 0.
    uint32_t seed = 1;
};

/// One wave of the gusts: amplitude cos(wave . (x - velocity t) + rate t + phase). The amplitude is across the wave, so
/// that air neither piles up nor thins out.
struct GustWave {
    Eigen::Vector3f wave{0, 0, 0};       ///< [rad/m]
    Eigen::Vector3f amplitude{0, 0, 0};  ///< [m/s]
    float phase = 0.0f, rate = 0.0f;     ///< [rad], [rad/s]
};

/// Waves of decreasing lengths from Wind::gustSize, as energetic as in turbulence (Kolmogorov: amplitude ~ length^1/3),
/// in random directions. The same seed gives the same waves everywhere; none without gusts.
std::vector<GustWave> gustWaves(const Wind& wind);

/// The air's velocity at a place and a time, without ForceFields that blow [m/s].
Eigen::Vector3f airVelocity(const Wind& wind, const std::vector<GustWave>& waves, const Eigen::Vector3f& place,
                            float time);

enum class FieldKind : uint32_t {
    Pull,   ///< Towards the middle of its region.
    Push,   ///< Away from it.
    Swirl,  ///< About its +Y.
    Blow    ///< Makes the air faster along its +Y.
};
enum class FieldFalloff : uint32_t {
    None,           ///< Everywhere the same.
    Linear,         ///< Nothing at the region's edge.
    InverseSquare,  ///< `strength` at a metre from the middle, a quarter at twice that.
};

/// Accelerates everything in its region alike, as gravity does; Blow acts by the air's drag.
struct ForceField {
    FieldKind kind = FieldKind::Pull;
    FieldFalloff falloff = FieldFalloff::Linear;
    Region region;          ///< Plane (all below it), box, sphere or capsule, whose axis is the middle.
    float strength = 0.0f;  ///< [m/s2], of Blow [m/s].
    float start = 0.0f, stop = std::numeric_limits<float>::infinity();  ///< When it begins and stops acting [s].
};

/// How far a field reaches from its middle [m].
float reachOf(const Region& region);

/// What a field adds at a place while it acts: an acceleration [m/s2], for Blow a velocity of the air [m/s].
Eigen::Vector3f fieldAt(const ForceField& field, const Eigen::Vector3f& place);

struct World;

/// Whether anything other than gravity acts from outside.
bool hasForces(const World& world);

/// @throws std::logic_error for values out of range, InputError for settings that forces do not work with.
void validateForces(const World& world);

/// Per mover (bodies, then loose particles), half of density times drag coefficient times area over its mass, along the
/// axes of the body at rest [1/m]; 0 without Wind. A body's area is what its particles cover seen along an axis; in
/// soft bodies each particle at the surface has a share. 0 for cloth: the air acts on its triangles.
std::vector<Eigen::Vector3f> dragsOf(const World& world);

}  // namespace knuckle
