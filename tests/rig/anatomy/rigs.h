#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle::test {

/// A program's names for a humanoid's bones. Chains run from a bone that is there, or from a root, outwards:
/// "Hips > {}UpLeg=thigh > {}Leg=shin", each new bone with what it should be read as. {} stands for a side; such chains
/// are there twice.
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

/// A humanoid without a surface, whose bones stand where their parts are, and what each bone should be read as.
/// Everything but what should be a control has skin.
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
