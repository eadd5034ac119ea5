#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/world/space/region.h"

namespace knuckle {

/// The air, which drags at whatever goes through it, and moves.
struct Wind {
    Eigen::Vector3f velocity{0, 0, 0};  ///< The mean [m/s].
    float density = 1.2f;               ///< Of the air [kg/m3], >= 0.
    float gusts = 0.3f;                 ///< Root of the mean square of what differs from the mean, over the mean's
                                        ///< size, 0 ... 2 (the intensity of turbulence).
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

/// Waves whose lengths go down from Wind::gustSize, as energetic as in turbulence (Kolmogorov: amplitude ~ length^1/3),
/// in random directions. The same seed gives the same everywhere; none without gusts.
std::vector<GustWave> gustWaves(const Wind& wind);

/// How fast the air is at a place and a time, without what ForceFields blow [m/s].
Eigen::Vector3f airVelocity(const Wind& wind, const std::vector<GustWave>& waves, const Eigen::Vector3f& place,
                            float time);

enum class FieldKind : uint32_t {
    Pull,   ///< Towards the middle of its region.
    Push,   ///< Away from it.
    Swirl,  ///< About its +Y.
    Blow    ///< The air is faster along its +Y.
};
enum class FieldFalloff : uint32_t {
    None,           ///< Everywhere the same.
    Linear,         ///< Nothing at the region's edge.
    InverseSquare,  ///< As far as a metre from the middle what `strength` says, at twice that a quarter.
};

/// Accelerates everything in its region alike, as gravity does; Blow acts by the air's drag.
struct ForceField {
    FieldKind kind = FieldKind::Pull;
    FieldFalloff falloff = FieldFalloff::Linear;
    Region region;          ///< Plane (all below it), box, sphere or capsule, whose axis is the middle.
    float strength = 0.0f;  ///< [m/s2], of Blow [m/s].
    float start = 0.0f, stop = std::numeric_limits<float>::infinity();  ///< When it acts [s].
};

/// How far a field goes from its middle [m].
float reachOf(const Region& region);

/// What a field adds at a place while it acts: to accelerations [m/s2], of Blow to the air's velocity [m/s].
Eigen::Vector3f fieldAt(const ForceField& field, const Eigen::Vector3f& place);

struct World;

/// Whether anything but gravity acts from outside.
bool hasForces(const World& world);

/// @throws std::logic_error for values out of range, InputError for settings that do not go with forces.
void validateForces(const World& world);

/// Per mover (bodies, then loose particles) half of density times drag coefficient times area over its mass, along the
/// axes of the body at rest [1/m]; 0 without Wind. A body's area is what its particles cover seen along an axis; of
/// soft bodies each particle at the surface has its share. Of cloth none: the air acts on its triangles.
std::vector<Eigen::Vector3f> dragsOf(const World& world);

}  // namespace knuckle
