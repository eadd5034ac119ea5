#include "sim/rig/limbs/rods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "sim/rig/limbs/limb_frame.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float WINDING = 0.35f;  // d: radius about the bone
constexpr float SAME = 0.11f;     // d: nearer ones are at one place, which files of actors may not have
// By quarter turns, so that two particles between the joints at its ends already leave the joints' plane.
constexpr std::array<std::array<float, 2>, 4> DIRECTIONS{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

}  // namespace

void windRods(const Figure& figure, const Solid& solid, Voxels& voxels, std::vector<uint32_t>& bones)
{
    const std::vector<BoneAnatomy>& anatomy = figure.anatomy;
    const size_t before = bones.size();
    std::vector<std::vector<Vector3f>> owned(anatomy.size());
    for (uint32_t p = 0; p < bones.size(); ++p) owned[bones[p]].push_back(voxels.positions[p]);
    std::vector<uint8_t> isRod(anatomy.size(), 0);
    for (uint32_t limb = 0; limb < anatomy.size(); ++limb) {
        if (owned[limb].empty() || spansSpace(owned[limb], voxels.diameter)) continue;
        const std::optional<Vector3f> end = limbEnd(figure, limb);
        if (!end) continue;
        const Vector3f head = figure.tree.heads[limb], way = *end - head;
        const int count = static_cast<int>(std::lround(way.norm() / voxels.diameter)) + 1;
        if (count < ROD_PARTICLES) continue;
        isRod[limb] = 1;
        const Vector3f along = way.normalized(), across = acrossLimb(along, figure.forward);
        // Rods of both sides wind as mirror images.
        const Vector3f beside = along.cross(across) * (anatomy[limb].side < 0 ? -1.0f : 1.0f);
        for (int k = 0; k < count; ++k) {
            const auto& [u, v] = DIRECTIONS[static_cast<size_t>(k) % DIRECTIONS.size()];
            const float part = static_cast<float>(k) / static_cast<float>(count - 1);
            voxels.add(solid, head + part * way + WINDING * voxels.diameter * (u * across + v * beside));
            bones.push_back(limb);
        }
    }
    const std::span<const Vector3f> wound = std::span(voxels.positions).subspan(before);
    const auto isTaken = [&](const Vector3f& place) {
        const auto isHere = [&](const Vector3f& other) { return (other - place).norm() < SAME * voxels.diameter; };
        return std::ranges::any_of(wound, isHere);
    };
    std::vector<uint32_t> kept, keptBones;
    for (uint32_t p = 0; p < bones.size(); ++p) {
        if (p < before && (isRod[bones[p]] != 0 || isTaken(voxels.positions[p]))) continue;
        kept.push_back(p);
        keptBones.push_back(bones[p]);
    }
    voxels = voxels.chosen(kept);
    bones = std::move(keptBones);
}

}  // namespace knuckle
