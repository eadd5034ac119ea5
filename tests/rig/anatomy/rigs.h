#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle::test {

/// A program's names for a humanoid's bones. Chains run outwards from an existing bone, or from a root: "Hips >
/// {}UpLeg=thigh > {}Leg=shin", each new bone with its expected reading. {} stands for a side; such chains exist twice.
struct Convention {
    std::string name;
    std::string left, right;
    std::vector<std::string> chains;
};

/// What a failure shows of it.
inline void PrintTo(const Convention& convention, std::ostream* out)
{
    *out << convention.name;
}

const std::vector<Convention>& conventions();

/// A humanoid without a surface, with bones at the places of their parts, and the expected reading of each bone.
/// Everything except controls has skin.
struct Rig {
    Model model;
    std::vector<std::string> expected;  ///< Per bone, the word behind its name.
    std::vector<int> sides;

    uint32_t add(const std::string& name, int32_t parent, const Eigen::Vector3f& head, const std::string& is = "",
                 int side = 0);
    uint32_t find(const std::string& name) const;
};

Rig makeRig(const Convention& convention);

}  // namespace knuckle::test
