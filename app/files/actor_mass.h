#pragma once

#include <string>
#include <vector>

#include "app/json/json.h"
#include "sim/rig/actor.h"

namespace knuckle {

/// What a body weighs as points with the masses of its particles.
struct ActorMass {
    float mass = 0.0f;                                  ///< [kg]
    Vector3f centre{0, 0, 0};                           ///< [m]
    Eigen::Matrix3f inertia = Eigen::Matrix3f::Zero();  ///< About the centre [kg m2].
};

/// Of each body. @param density of its particles [kg/m3]. @throws InputError for an actor that no scene can have.
std::vector<ActorMass> massesOf(const Actor& actor, float density = 1000.0f);

/// `mass`, `centre` and `inertia` of the bodies of a document follow from the particles: checks those that it has.
/// @throws InputError for the first that is another than at 1000 kg/m3.
void requireMasses(const std::string& path, const Json& root, const Actor& actor);

}  // namespace knuckle
