#pragma once

#include "tests/solver/contact/contact_reference.h"
#include "tests/solver/search/search_test.h"

namespace knuckle::test {

/// The exit direction for the first of a pair, as the kernel decides it, and whether the pair is deep.
struct WayOut {
    Vector3d away{0, 0, 0};
    bool deep = false;
};

/// How a pair parts: by the exit direction, mirrored, by a face, or directly from each other.
struct Parting {
    Vector3d normal;
    double far = 0.0;
    uint32_t hidden = 0;
    bool oneSided = false;
    bool sure = true;  ///< Not so near a limit that rounding decides.
};

/// How pairs part, implemented anew from the rules, among randomly turned bodies.
class PartingFixture : public SearchBench {
public:
    PartingFixture();

    /// By the particle nearer to its surface, or between both; none within an assembly.
    WayOut wayOut(uint32_t i, uint32_t j) const;
    Parting partingOf(uint32_t i, uint32_t j) const;
    /// Inverse masses for impulses on a particle at r of its body.
    SideMass massOf(uint32_t particle, const Vector3f& r, const Vector3d& normal) const;

private:
    /// Sets turns of the movers, and inverse inertias unlike those of boxes: none of their entries is zero [1/(kg m2)].
    void setTurnsAndInertias();
    /// Where a box without joints continues from the particle towards another beside it, that component of the other's
    /// place does not count. Sets `sure` to false if rounding decides.
    Vector3d shown(uint32_t particle, const Vector3d& towards, uint32_t& hidden, bool& sure) const;

    std::vector<Quaternionf> turns_;  ///< Per mover.
    std::vector<Matrix3d> inertias_;  ///< Per body, inverse.
    std::vector<uint32_t> bodiesOfAssembly_;
};

}  // namespace knuckle::test
