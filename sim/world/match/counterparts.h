#pragma once

#include <string>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// What two worlds have in common, by the names that the scene gives. Each list is per thing of the later world: the
/// index of the same thing in the earlier one, or NO_INDEX if it is new.
struct Counterparts {
    std::vector<uint32_t> particles, bodies, softBodies, strands, emitters, colliders;
    /// Names of objects, of `/emitters/N`: what both have, what only the later one has, what only the earlier one has.
    /// What both have by its name but not by its shape is new and gone.
    std::vector<std::string> kept, added, gone;
};

/// An object is the same if it has the same name, and bodies with the same names and particles; soft bodies if
/// they have the same clusters; ropes and cloth if they have as many particles and the same rest lengths between them;
/// grains if they are as many; a fluid if it has the same name, as far as its particles begin at the same places. Of
/// several with one name the first is the first's. Emitters are the same by their number and the name of their fluid,
/// colliders by shape and place.
Counterparts counterparts(const World& before, const World& after);

}  // namespace knuckle
