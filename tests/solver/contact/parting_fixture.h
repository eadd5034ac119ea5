#pragma once

#include "tests/solver/contact/contact_reference.h"
#include "tests/solver/search/search_test.h"

namespace knuckle::test {

/// The way out for the first of a pair, as the kernel decides it, and whether it is deep.
struct WayOut {
    Vector3d away{0, 0, 0};
    bool deep = false;
};

/// How a pair parts: by the way out, mirrored, by a face, or simply from each other.
struct Parting {
    Vector3d normal;
    double far = 0.0;
    uint32_t hidden = 0;
    bool oneSided = false;
    bool sure = true;  ///< Not so near a limit that rounding decides.
};

/// How pairs part, written anew from the rules, among bodies that are turned at random.
class PartingFixture : public SearchBench {
public:
    PartingFixture();

    /// By the particle that is nearer to its surface, or between both; none within an assembly.
    WayOut wayOut(uint32_t i, uint32_t j) const;
    Parting partingOf(uint32_t i, uint32_t j) const;
    /// What impulses on a particle at r of its body meet.
    SideMass massOf(uint32_t particle, const Vector3f& r, const Vector3d& normal) const;

private:
    /// Turns of the movers, and inverse inertias of the bodies that no box has: nothing in them is zero [1/(kg m2)].
    void setTurnsAndInertias();
    /// Where a box without joints goes on from the particle towards another beside it, the other's place does not
    /// count. `sure` becomes false where rounding decides.
    Vector3d shown(uint32_t particle, const Vector3d& towards, uint32_t& hidden, bool& sure) const;

    std::vector<Quaternionf> turns_;  ///< Per mover.
    std::vector<Matrix3d> inertias_;  ///< Per body, inverse.
    std::vector<uint32_t> bodiesOfAssembly_;
};

}  // namespace knuckle::test
