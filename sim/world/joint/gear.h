#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

struct World;

/// Couples two hinges, as wheels do whose teeth mesh, or a belt: the second turns by `ratio` times as much as the
/// first, from where both stand at the start, and its torque is 1 / ratio of the first's.
struct Gear {
    std::string name;
    uint32_t first = NO_INDEX, second = NO_INDEX;  ///< Indices into World::joints, of hinges (Joint::geared).
    float ratio = -1.0f;                           ///< Turns of the second per turn of the first, not 0; below 0: the
                                                   ///< other way, if both axes point the same way.
};

/// A hinge by its two bodies.
struct HingeBodies {
    uint32_t parent = NO_INDEX, child = NO_INDEX;
};

/// A gear as described, before its hinges have indices.
struct GearDraft {
    std::string name;
    HingeBodies first, second;
    float ratio = -1.0f;
};

/// Hinges that gears connect: they turn as one.
struct GearTrain {
    struct Hinge {
        uint32_t joint = NO_INDEX;   ///< Index into World::joints.
        uint32_t before = NO_INDEX;  ///< Index of an earlier hinge of the train that a gear couples it with; of the
                                     ///< first NO_INDEX.
        float ratio = 1.0f;          ///< Its turns per turn of the first.
    };
    std::vector<Hinge> hinges;
};

/// The trains of a world's gears. @throws InputError where gears close a ring that cannot turn.
std::vector<GearTrain> gearTrainsOf(const World& world);

/// Validates gears. @throws InputError.
void validateGears(const World& world);

}  // namespace knuckle
