#pragma once

#include "app/scene/overrides.h"

namespace knuckle {

/// The ball that viewers throw: a body of the scene that is not there before.
constexpr const char* BALL = "thrown_ball";

/// Gives a scene one. @param radius [m]
inline Override ballOf(double radius)
{
    // A release that nobody lives to see, so that it may be let go before.
    constexpr double NEVER = 1e6;
    return {"objects.-",
            {{"type", "rigid"},
             {"shape", "sphere"},
             {"name", BALL},
             {"radius", radius},
             {"fixed", true},
             {"release", {{"time", NEVER}, {"appears", true}}}}};
}

}  // namespace knuckle
