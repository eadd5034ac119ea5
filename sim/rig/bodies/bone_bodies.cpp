#include "sim/rig/bodies/bone_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "sim/base/short_list.h"
#include "sim/rig/anatomy/chain_parts.h"
#include "sim/rig/anatomy/facing.h"
#include "sim/rig/bodies/body_tree.h"
#include "sim/rig/bodies/bone_merge.h"
#include "sim/rig/limbs/limb_owner.h"
#include "sim/rig/limbs/mirror_particles.h"
#include "sim/rig/limbs/rods.h"
#include "sim/world/space/cells.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float FINER = 0.8f;         // factor for a diameter that is too large, if nothing else is known
constexpr double ISLAND_PART = 0.25;  // a cut-off part below this share of its body changes sides
constexpr double APART_PART = 0.9;    // a part that hangs apart does so below this share of the largest
constexpr float LOOSE = 2.6f;         // d: from all else of its body

constexpr size_t FEW = 6;           // bodies up to which each is named
constexpr std::ptrdiff_t ENDS = 4;  // least outermost bodies of a figure with arms and legs
constexpr float LYING = 1.5f;       // depth over height of a figure that lies

using Particles = std::vector<uint32_t>;

// The voxels' lattice, reconstructed: each particle is in the middle of its own cell, whatever the rounding.
class VoxelCells {
public:
    explicit VoxelCells(const Voxels& voxels) : voxels_(voxels), cells_(voxels.diameter)
    {
        for (uint32_t p = 0; p < voxels.positions.size(); ++p) cells_.add(place(p), p);
    }
    // Calls visit(index) for the particle and its neighbours.
    template <typename Visit>
    void forEachAround(uint32_t particle, Visit visit) const
    {
        cells_.forEachAround(place(particle), visit);
    }

private:
    Vector3f place(uint32_t particle) const
    {
        return voxels_.positions[particle] - voxels_.positions.front() + Vector3f::Constant(0.5f * voxels_.diameter);
    }
    const Voxels& voxels_;
    Cells cells_;
};

/// Whether a piece is away from all others of its bone.
bool isApart(const Particles& part, const std::vector<Particles>& parts, const std::vector<uint32_t>& bones,
             const Voxels& voxels)
{
    return std::ranges::none_of(parts, [&](const Particles& other) {
        return &other != &part && bones[other.front()] == bones[part.front()] &&
               contactOf(part, other, voxels).distance < LOOSE * voxels.diameter;
    });
}

// If the skin's weights cut a bone's particles into pieces, small pieces and those that hang apart go to other bones
// whose particles they touch.
void moveIslands(std::vector<uint32_t>& bones, const Voxels& voxels)
{
    const VoxelCells cells(voxels);
    std::vector<Particles> parts;
    std::vector<uint8_t> seen(bones.size(), 0);
    std::map<uint32_t, size_t> sizes, largest;
    for (uint32_t seed = 0; seed < bones.size(); ++seed) {
        if (seen[seed]) {
            continue;
        }
        seen[seed] = 1;
        Particles part{seed};
        for (size_t i = 0; i < part.size(); ++i) {
            cells.forEachAround(part[i], [&](uint32_t other) {
                if (!seen[other] && bones[other] == bones[seed]) {
                    seen[other] = 1;
                    part.push_back(other);
                }
            });
        }
        sizes[bones[seed]] += part.size();
        largest[bones[seed]] = std::max(largest[bones[seed]], part.size());
        parts.push_back(std::move(part));
    }
    const std::vector<uint32_t> before = bones;
    for (const Particles& part : parts) {
        const uint32_t own = before[part.front()];
        const auto size = static_cast<double>(part.size());
        const bool isSmall = size < ISLAND_PART * static_cast<double>(sizes[own]);
        const bool isOther = size < APART_PART * static_cast<double>(largest[own]);
        if (!isSmall && !(isOther && isApart(part, parts, before, voxels))) continue;
        std::map<uint32_t, size_t> touching;
        for (uint32_t particle : part) {
            cells.forEachAround(particle, [&](uint32_t other) { touching[before[other]] += before[other] != own; });
        }
        touching.erase(own);
        const auto most = std::max_element(touching.begin(), touching.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        for (uint32_t particle : part) {
            bones[particle] = most == touching.end() ? own : most->first;
        }
    }
}

std::vector<BodyDraft> draftBodies(const Figure& figure, BoneCut& cut)
{
    const Model& model = figure.model;
    const std::vector<BoneAnatomy>& anatomy = figure.anatomy;
    std::vector<BodyDraft> drafts;
    std::vector<int32_t> draftOf(model.bones.size(), -1);
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        if (cut.particles[b].empty()) continue;
        draftOf[b] = static_cast<int32_t>(drafts.size());
        std::ranges::sort(cut.merged[b]);
        std::sort(cut.particles[b].begin(), cut.particles[b].end());
        drafts.push_back({model.bones[b].name, b, -1, std::move(cut.particles[b]), cut.merged[b], boneHead(model, b)});
    }
    for (BodyDraft& draft : drafts)
        for (int32_t above = anatomy[draft.bone].parent; above >= 0 && draft.parent < 0; above = anatomy[above].parent)
            draft.parent = draftOf[above];
    return drafts;
}

void hangAsPlanned(const BodyPlan& plan, std::vector<BodyDraft>& drafts)
{
    for (BodyDraft& draft : drafts) {
        const auto parent = std::ranges::find(drafts, plan.above[draft.bone], &BodyDraft::bone);
        draft.parent = parent == drafts.end() ? -1 : static_cast<int32_t>(parent - drafts.begin());
    }
}

/// Notes which limbs of arms and legs have no joint, and how to give them one.
void noteLost(const Figure& figure, const BoneCut& cut, float diameter, std::vector<std::string>& notes)
{
    const std::vector<BoneAnatomy>& anatomy = figure.anatomy;
    std::vector<uint8_t> hasSkin(anatomy.size(), 0);
    for (uint32_t b = 0; b < anatomy.size(); ++b)
        if (figure.tree.deforms[b]) hasSkin[anatomy[b].owner] = 1;
    for (uint32_t b = 0; b < anatomy.size(); ++b) {
        const std::optional<Vector3f> end = limbEnd(figure, b);
        const bool lost = hasSkin[b] && isLongLimb(anatomy[b].part) && cut.particles[b].empty();
        if (!lost || !end) continue;
        const float length = (*end - figure.tree.heads[b]).norm();
        const float enough = std::min(length / (ROD_PARTICLES - 1), FINER * diameter);
        notes.push_back(
            fmt::format("{} has no joint of its own, since it is too small for one: --diameter {:.2g} gives "
                        "it one.",
                        figure.model.bones[b].name, enough));
    }
}

/// Notes which bodies hang elsewhere than their bones.
void noteReattached(const Figure& figure, const std::vector<BodyDraft>& drafts, std::vector<std::string>& notes)
{
    const std::vector<BoneAnatomy>& anatomy = figure.anatomy;
    std::vector<std::string> names, each;
    for (const BodyDraft& draft : drafts) {
        if (draft.parent < 0) continue;
        const uint32_t parent = drafts[draft.parent].bone;
        const int32_t above = figure.tree.above(
            draft.bone, [&](uint32_t b) { return std::ranges::count(drafts, anatomy[b].owner, &BodyDraft::bone) > 0; });
        const bool asBones = above >= 0 && anatomy[above].owner == parent;
        if (asBones || anatomy[draft.bone].source != AnatomySource::Name) continue;
        names.push_back(draft.name);
        each.push_back(fmt::format("{} is joined to {}, which its part of a body belongs to.", draft.name,
                                   drafts[draft.parent].name));
    }
    if (each.size() <= FEW) notes.insert(notes.end(), each.begin(), each.end());
    else notes.push_back(fmt::format("Joined to what their parts of a body belong to: {}.", shortList(names)));
}

/// Notes what was not read from names.
void noteSources(const Figure& figure, std::vector<std::string>& notes)
{
    const Model& model = figure.model;
    const std::vector<BoneAnatomy>& anatomy = figure.anatomy;
    const auto count = [&](AnatomySource source) { return std::ranges::count(anatomy, source, &BoneAnatomy::source); };
    const bool named = std::ranges::any_of(
        anatomy, [](const BoneAnatomy& bone) { return bone.source == AnatomySource::Name && isLongLimb(bone.part); });
    if (const auto bones = count(AnatomySource::Shape); bones > 0)
        notes.push_back(fmt::format("The names of bones name {} limbs: {} of {} are what the skeleton's shape says.",
                                    named ? "not all" : "no", bones, model.bones.size()));
    std::vector<std::string> hinges;
    for (size_t b = 0; b < anatomy.size(); ++b)
        if (anatomy[b].source == AnatomySource::Clip) hinges.push_back(model.bones[b].name);
    if (!hinges.empty())
        notes.push_back(fmt::format("Hinges, since clips turn them about one axis: {}.", shortList(hinges)));
}

/// Notes a remedy if nothing tells which bones are limbs.
void noteUnknown(const Figure& figure, const std::vector<BodyDraft>& drafts, std::vector<std::string>& notes)
{
    const auto isKnown = [](const BoneAnatomy& bone) {
        return bone.source == AnatomySource::Clip ||
               (bone.part != BodyPart::Other && bone.part != BodyPart::Hips && bone.part != BodyPart::Spine &&
                bone.part != BodyPart::Head && bone.part != BodyPart::Neck);
    };
    std::vector<uint8_t> isEnd(drafts.size(), 1);
    for (const BodyDraft& draft : drafts)
        if (draft.parent >= 0) isEnd[draft.parent] = 0;
    if (std::ranges::count(isEnd, 1) < ENDS || std::ranges::any_of(figure.anatomy, isKnown)) return;
    Eigen::AlignedBox3f box;
    for (const Vector3f& vertex : figure.model.vertices) box.extend(vertex);
    const bool lies = box.sizes().z() > LYING * box.sizes().y();
    notes.push_back(fmt::format(
        "Neither the names of bones nor the skeleton's shape tell arms and legs: no joint is a knee or an elbow. Names "
        "like \"thigh.L\" do, or --joints{}.",
        lies ? "; and where the figure should stand but lies, --up z stands it up" : ""));
}

}  // namespace

std::vector<BodyDraft> cutIntoBodies(const Figure& figure, const Solid& solid, Voxels& voxels, const BodyPlan& plan,
                                     std::vector<std::string>& notes)
{
    if (!figure.hasSkin()) {
        BodyDraft whole;
        whole.name = figure.model.name;
        whole.particles.resize(voxels.positions.size());
        std::iota(whole.particles.begin(), whole.particles.end(), 0u);
        return {whole};
    }
    LimbOwner owner(figure);
    std::vector<uint32_t> bones;
    for (const Vector3f& place : voxels.positions) bones.push_back(owner.at(solid.tree().nearestAround(place)));
    moveIslands(bones, voxels);
    if (figure.mirror) mirrorParticles(solid, *figure.mirror, figure.tree.parents, voxels, bones);
    windRods(figure, solid, voxels, bones);
    BoneCut cut = plan.empty() ? mergeSmall(figure.tree, figure.anatomy, voxels, bones)
                               : mergePlanned(figure, voxels, bones, plan);
    if (plan.empty()) noteLost(figure, cut, voxels.diameter, notes);
    std::vector<BodyDraft> drafts = draftBodies(figure, cut);
    if (!plan.empty()) hangAsPlanned(plan, drafts);
    noteReattached(figure, drafts, notes);
    arrangeTree(drafts, figure.tree, figure.anatomy, voxels, notes);
    noteSources(figure, notes);
    noteUnknown(figure, drafts, notes);
    if (std::string note = facingNote(figure.model, figure.anatomy); !note.empty()) notes.push_back(std::move(note));
    return drafts;
}

}  // namespace knuckle
