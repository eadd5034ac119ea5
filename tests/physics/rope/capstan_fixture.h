#pragma once

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

/// A rope with a load at each end, hung over fixed drums along z.
struct Capstan {
    enum class Way {
        Half,     ///< Half a turn about one drum.
        Corners,  ///< A quarter each about two drums.
        Wound,    ///< One and a half turns about one drum, beside each other.
    };
    Way way = Way::Half;
    uint32_t substeps = 4;
    float friction = 0.3f;
    float left = 20.0f, right = 20.0f;  ///< Loads [kg].
    float massPerLength = 0.012f;       ///< [kg/m]
    float hang = 1.0f;                  ///< Length of both ends [m].
    bool boxes = false;                 ///< Whether the loads are boxes, not particles.
    float swing = 0.0f;                 ///< Speed of the loads at the start, the left one to the left [m/s].

    static constexpr float THICKNESS = 0.04f, RADIUS = 0.2f;

    World world() const;
    /// The angle about which the rope is bent [rad].
    double angle() const;
};

/// What a rope did.
struct CapstanRun {
    double sunk = 0.0;       ///< Deepest in a drum in any frame [m].
    double stretched = 0.0;  ///< Most by which its length was off [m].
    double gained = 0.0;     ///< Most that its energy was above the start [J].
    double moved = 0.0;      ///< How far the left load has sunk in the end [m].
    double between = 0.0;    ///< And in the first half of the time.
};

CapstanRun runCapstan(const Capstan& spec, double seconds);

}  // namespace knuckle::test
