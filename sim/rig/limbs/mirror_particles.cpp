#include "sim/rig/limbs/mirror_particles.h"

#include <algorithm>
#include <cmath>

#include "sim/world/space/cells.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float ON_PLANE = 0.25f;   // d
constexpr float SAME_POINT = 0.1f;  // d: distance of a particle's image from the particle there
constexpr float ALIKE = 0.5f;       // d: difference of distances to the surface at a particle and at its image
constexpr float NEXT = 1.2f;        // d: face to face on the lattice

/// Indices of the particles by place.
class Places {
public:
    explicit Places(const Voxels& voxels) : voxels_(voxels), cells_(voxels.diameter)
    {
        for (uint32_t p = 0; p < voxels.positions.size(); ++p) cells_.add(voxels.positions[p], p);
    }
    uint32_t at(const Vector3f& place) const
    {
        uint32_t found = NO_INDEX;
        cells_.forEachAround(place, [&](uint32_t p) {
            if ((voxels_.positions[p] - place).norm() < SAME_POINT * voxels_.diameter) found = p;
        });
        return found;
    }

private:
    const Voxels& voxels_;
    Cells cells_;
};

/// Particles on the plane that belong to a bone beside it. Between two bones that mirror each other they belong to an
/// adjacent trunk, else to neither, as on the seam of two legs that touch.
class Seam {
public:
    Seam(const Mirror& mirror, const std::vector<int32_t>& parents, const Voxels& voxels,
         const std::vector<uint32_t>& bones)
        : mirror_(mirror), parents_(parents), voxels_(voxels), bones_(bones), cells_(NEXT * voxels.diameter)
    {
        for (uint32_t p = 0; p < bones.size(); ++p) cells_.add(voxels.positions[p], p);
    }

    bool isOn(uint32_t particle) const { return std::abs(distance(particle)) < ON_PLANE * voxels_.diameter; }

    /// The bone of a particle on the plane; NO_INDEX: it belongs to none.
    uint32_t boneOf(uint32_t particle) const
    {
        const uint32_t own = bones_[particle], image = mirror_.images[own];
        auto above = static_cast<int32_t>(own);
        while (above >= 0 && mirror_.images[above] != static_cast<uint32_t>(above)) above = parents_[above];
        if (above < 0 || image == own) return own;
        bool atTrunk = false, left[2] = {false, false}, right[2] = {false, false};
        cells_.forEachAround(voxels_.positions[particle], [&](uint32_t other) {
            if ((voxels_.positions[other] - voxels_.positions[particle]).norm() > NEXT * voxels_.diameter) return;
            const bool isMinus = distance(other) < 0.0f;
            atTrunk = atTrunk || bones_[other] == static_cast<uint32_t>(above);
            if (isOn(other)) return;
            left[isMinus] = left[isMinus] || bones_[other] == own;
            right[isMinus] = right[isMinus] || bones_[other] == image;
        });
        if (atTrunk) return static_cast<uint32_t>(above);
        const bool between = (left[0] && right[1]) || (left[1] && right[0]);
        return between ? NO_INDEX : own;
    }

private:
    float distance(uint32_t particle) const { return mirror_.plane.distance(voxels_.positions[particle]); }

    const Mirror& mirror_;
    const std::vector<int32_t>& parents_;
    const Voxels& voxels_;
    const std::vector<uint32_t>& bones_;
    Cells cells_;
};

}  // namespace

void mirrorParticles(const Solid& solid, const Mirror& mirror, const std::vector<int32_t>& parents, Voxels& voxels,
                     std::vector<uint32_t>& bones)
{
    const Places places(voxels);
    const Seam seam(mirror, parents, voxels, bones);
    const float d = voxels.diameter;
    std::vector<uint32_t> kept, keptBones;
    const uint32_t count = static_cast<uint32_t>(voxels.positions.size());
    for (uint32_t p = 0; p < count; ++p) {
        const Vector3f image = mirror.plane.mirrored(voxels.positions[p]);
        const float side = mirror.plane.distance(voxels.positions[p]);
        const uint32_t other = places.at(image);
        uint32_t bone = bones[p];
        if (seam.isOn(p)) {
            bone = seam.boneOf(p);
            if (bone == NO_INDEX) continue;
        } else if (other != NO_INDEX) {
            const uint32_t mirrored = mirror.images[bones[other]];
            if (side < 0.0f && mirrored != NO_INDEX) bone = mirrored;
        } else {
            const float there = solid.signedDistance(image);
            const bool alike = std::abs(there - voxels.signedDistances[p]) < ALIKE * d;
            const bool mirrors = alike && mirror.images[bone] != NO_INDEX;
            if (mirrors && side < 0.0f) continue;
            if (mirrors) {
                kept.push_back(static_cast<uint32_t>(voxels.positions.size()));
                keptBones.push_back(mirror.images[bone]);
                voxels.add(solid, image);
            }
        }
        kept.push_back(p);
        keptBones.push_back(bone);
    }
    voxels = voxels.chosen(kept);
    bones = std::move(keptBones);
}

}  // namespace knuckle
