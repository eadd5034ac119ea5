#pragma once

#include <cstdint>

namespace knuckle {

/// How a surface takes the light, by one word; FINISHES of render/looks/finishes.cpp says what each is.
enum class Finish : uint32_t {
    Default,
    Matte,
    Plastic,
    Clay,
    Wax,
    Rubber,
    Metal,
    Wood,
    Checker,
    Brushed,
    Glass,  ///< Light goes through shapes and colliders.
    Model,  ///< Of skins: as the model says. Of others: default.
};

/// A finish, and what differs from it.
struct SurfaceFinish {
    Finish word = Finish::Default;
    float roughness = -1.0f;  ///< 0 ... 1; below 0: that of the word.
    float metalness = -1.0f;  ///< 0 ... 1; below 0: that of the word.
    float emission = 0.0f;  ///< Light that it sends out in its colour; 1 is about what white in full light sends back.

    bool operator==(const SurfaceFinish&) const = default;
};

/// What a plane shows.
enum class FloorLook : uint32_t { Default, Studio, Tiles, Checker, Wood, Grass, Grid, Mirror, None };

}  // namespace knuckle
