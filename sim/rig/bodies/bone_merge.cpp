#include "sim/rig/bodies/bone_merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "sim/base/errors.h"
#include "sim/rig/bodies/body_tree.h"
#include "sim/rig/bodies/bone_bodies.h"

namespace knuckle {

namespace {

bool isLarge(const std::vector<uint32_t>& particles, const Voxels& voxels)
{
    std::vector<Eigen::Vector3f> positions;
    for (const uint32_t particle : particles) positions.push_back(voxels.positions[particle]);
    return spansSpace(positions, voxels.diameter);
}

/// Bones, outer ones first.
std::vector<uint32_t> outerFirst(std::span<const BoneAnatomy> anatomy)
{
    std::vector<uint32_t> order(anatomy.size()), depth(anatomy.size(), 0);
    std::iota(order.rbegin(), order.rend(), 0u);
    for (size_t b = 0; b < anatomy.size(); ++b)
        for (int32_t above = anatomy[b].parent; above >= 0; above = anatomy[above].parent) ++depth[b];
    std::ranges::stable_sort(order, std::greater<>(), [&](uint32_t b) { return depth[b]; });
    return order;
}

void join(BoneCut& cut, const BoneTree& tree, uint32_t from, uint32_t to)
{
    cut.particles[to].insert(cut.particles[to].end(), cut.particles[from].begin(), cut.particles[from].end());
    cut.merged[to].insert(cut.merged[to].end(), cut.merged[from].begin(), cut.merged[from].end());
    if (tree.deforms[from]) cut.merged[to].push_back(from);
    cut.particles[from].clear();
    cut.merged[from].clear();
}

/// The bone with a large body that is nearest in the skeleton; `bone` itself if there is none.
uint32_t nearestLarge(const BoneCut& cut, const BoneTree& tree, const Voxels& voxels, uint32_t bone)
{
    const std::vector<uint32_t> steps = tree.stepsFrom(bone);
    uint32_t target = bone;
    Contact nearest;
    for (uint32_t other = 0; other < tree.size(); ++other) {
        const bool fartherOff = target != bone && steps[other] > steps[target];
        if (other == bone || fartherOff || !isLarge(cut.particles[other], voxels)) continue;
        const Contact contact = contactOf(cut.particles[bone], cut.particles[other], voxels);
        const bool nearer = target == bone || steps[other] < steps[target] || contact.distance < nearest.distance;
        if (!nearer) continue;
        target = other;
        nearest = contact;
    }
    return target;
}

}  // namespace

BoneCut mergeSmall(const BoneTree& tree, std::span<const BoneAnatomy> anatomy, const Voxels& voxels,
                   const std::vector<uint32_t>& bones)
{
    BoneCut cut;
    cut.particles.resize(anatomy.size());
    cut.merged.resize(anatomy.size());
    for (uint32_t p = 0; p < bones.size(); ++p) cut.particles[bones[p]].push_back(p);
    for (uint32_t b = 0; b < anatomy.size(); ++b)
        if (anatomy[b].owner != b && tree.deforms[b]) cut.merged[anatomy[b].owner].push_back(b);
    for (const uint32_t b : outerFirst(anatomy)) {
        int32_t above = anatomy[b].parent;
        while (above >= 0 && cut.particles[above].empty()) above = anatomy[above].parent;
        if (above >= 0 && !isLarge(cut.particles[b], voxels)) join(cut, tree, b, static_cast<uint32_t>(above));
    }
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        if (cut.particles[b].empty() || isLarge(cut.particles[b], voxels)) continue;
        if (const uint32_t target = nearestLarge(cut, tree, voxels, b); target != b) join(cut, tree, b, target);
    }
    return cut;
}

BoneCut mergePlanned(const Figure& figure, const Voxels& voxels, const std::vector<uint32_t>& bones,
                     const BodyPlan& plan)
{
    BoneCut cut;
    cut.particles.resize(plan.owners.size());
    cut.merged.resize(plan.owners.size());
    for (uint32_t p = 0; p < bones.size(); ++p) cut.particles[plan.owners[bones[p]]].push_back(p);
    for (uint32_t b = 0; b < plan.owners.size(); ++b) {
        if (!plan.hasBody(b)) {
            if (figure.tree.deforms[b]) cut.merged[plan.owners[b]].push_back(b);
        } else if (!isLarge(cut.particles[b], voxels)) {
            throw InputError(fmt::format("{}: particles of {:.3g} m are too few for the body {}, which the coarsest "
                                         "level has; add a coarser level, or leave this one out",
                                         figure.model.name, voxels.diameter, figure.model.bones[b].name));
        }
    }
    return cut;
}

}  // namespace knuckle
