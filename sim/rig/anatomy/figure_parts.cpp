#include "sim/rig/anatomy/figure_parts.h"

#include <algorithm>
#include <cmath>

#include "sim/rig/anatomy/chain_parts.h"
#include "sim/rig/anatomy/shape/mirror_plane.h"

namespace knuckle {

namespace {

constexpr float LOW = 0.25f;           // of a leg's height: height of its foot
constexpr std::ptrdiff_t FINGERS = 3;  // of a hand at least
constexpr float TRUNK = 0.15f;         // of a figure's size: the least height of its upright trunk

class FigureParts {
public:
    FigureParts(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
        : tree_(tree), names_(names), anatomy_(anatomy)
    {
    }

    void read()
    {
        callLevers();
        orderChains();
        callEnds();
        callForeLegs();
        findHips();
        closeSpine();
        findHead();
    }

private:
    BodyPart partAbove(uint32_t b) const { return knuckle::partAbove(tree_, anatomy_, b); }

    /// Arms without a side, in a skeleton without legs, head or a hand of several fingers, are levers of a machine.
    void callLevers()
    {
        const auto isAnimals = [](const BoneAnatomy& bone) {
            const bool arm = ofForeLeg(bone.part) == bone.part && isLimbPart(bone.part) && bone.part != BodyPart::Toe;
            return bone.part == BodyPart::Hips || bone.part == BodyPart::Neck || bone.part == BodyPart::Head ||
                   (isLimbPart(bone.part) && (bone.side != 0 || !arm));
        };
        const auto isFinger = [&](uint32_t b) { return anatomy_[b].part == BodyPart::Finger; };
        if (std::ranges::any_of(anatomy_, isAnimals) || std::ranges::any_of(tree_.children, [&](const auto& siblings) {
                return std::ranges::count_if(siblings, isFinger) >= FINGERS;
            }))
            return;
        for (BoneAnatomy& bone : anatomy_)
            if (isLimbPart(bone.part)) bone.part = BodyPart::Lever;
    }

    /// A bone below a foot is a toe, one above a shin a thigh, whatever their names: "Leg_Tip", "Leg_Knee".
    void orderChains()
    {
        using enum BodyPart;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart part = anatomy_[b].part, above = partAbove(b);
            const bool leg = part == Coxa || part == Thigh || part == Shin || part == Foot;
            const bool arm = part == Clavicle || part == UpperArm || part == Forearm;
            const bool inFoot = above == Foot || above == Toe, inHand = above == Hand || above == Finger;
            if ((leg || arm) && inFoot) anatomy_[b].part = Toe;
            else if ((leg || arm) && inHand) anatomy_[b].part = leg ? Toe : Finger;
            else if ((part == Thigh || part == Coxa) && above == Shin) anatomy_[b].part = Shin;
            else if ((part == UpperArm || part == Clavicle) && above == Forearm) anatomy_[b].part = Forearm;
            else if (carriesShin(b)) anatomy_[b].part = Thigh;
        }
    }

    /// Whether a bone with no part of a leg above it is followed by a shin.
    bool carriesShin(uint32_t b) const
    {
        using enum BodyPart;
        const BodyPart part = anatomy_[b].part, above = partAbove(b);
        const int32_t parent = tree_.parents[b];
        if ((part != Shin && part != Foot && part != Toe) || anatomy_[b].side == 0 || !tree_.deforms[b]) return false;
        // An unnamed bone may be the thigh.
        const bool unknown = parent >= 0 && tree_.deforms[parent] && anatomy_[parent].part == Other;
        if (unknown || (isLimbPart(above) && above != Coxa)) return false;
        const int32_t next = tree_.below(b, [&](uint32_t other) {
            return tree_.deforms[other] && isLimbPart(anatomy_[other].part) && anatomy_[other].side == anatomy_[b].side;
        });
        return next >= 0 && anatomy_[next].part == Shin;
    }

    /// If a limb's bones are numbered and none is called foot or hand, the third one is, for a creature's leg only near
    /// the ground.
    void callEnds()
    {
        const bool upright = std::ranges::count(anatomy_, BodyPart::Thigh, &BoneAnatomy::part) <= 2;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart part = anatomy_[b].part, above = partAbove(b);
            const bool leg = part == BodyPart::Shin && names_[b].part == NamedPart::Leg;
            const bool arm = part == BodyPart::Forearm && names_[b].part == NamedPart::Arm;
            if ((!leg && !arm) || names_[b].isEnd || endsBelow(b)) continue;
            const BodyPart end = leg ? BodyPart::Foot : BodyPart::Hand, tip = leg ? BodyPart::Toe : BodyPart::Finger;
            if (above == end || above == tip) anatomy_[b].part = tip;
            else if (above == part && (arm || upright || isLow(b))) anatomy_[b].part = end;
        }
    }

    bool endsBelow(uint32_t b) const
    {
        return tree_.below(b, [&](uint32_t other) {
            const BodyPart part = anatomy_[other].part;
            return part == BodyPart::Foot || part == BodyPart::Hand || part == BodyPart::Toe;
        }) >= 0;
    }

    /// Whether a bone of a leg begins in the lowest quarter of it.
    bool isLow(uint32_t b) const
    {
        const int32_t thigh = tree_.above(b, [&](uint32_t other) { return anatomy_[other].part == BodyPart::Thigh; });
        if (thigh < 0) return false;
        float lowest = tree_.heads[b].y();
        for (uint32_t other = b; other < tree_.size(); ++other)
            if (tree_.isBelow(static_cast<int32_t>(other), b))
                lowest = std::min({lowest, tree_.heads[other].y(), tree_.tips[other].y()});
        return tree_.heads[b].y() - lowest < LOW * (tree_.heads[thigh].y() - lowest);
    }

    /// Of four legs, the front ones are arms: those that hang on a shoulder, or of two on a side the one next to the
    /// head.
    void callForeLegs()
    {
        std::vector<uint32_t> thighs[2];
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart above = partAbove(b);
            if (anatomy_[b].part == BodyPart::Foot && above == BodyPart::Forearm) callForeLeg(b);
            if (anatomy_[b].part != BodyPart::Thigh || above == BodyPart::Thigh) continue;
            if (above == BodyPart::Clavicle || above == BodyPart::UpperArm) callForeLeg(b);
            else if (names_[b].side != 0) thighs[names_[b].side < 0].push_back(b);
        }
        const uint32_t head = std::min(firstOf(BodyPart::Head), firstOf(BodyPart::Neck));
        const bool four = thighs[0].size() == 2 && thighs[1].size() == 2 && firstOf(BodyPart::UpperArm) == tree_.size();
        if (!four || head == tree_.size()) return;
        const auto away = [&](uint32_t b) { return (tree_.heads[b] - tree_.heads[head]).norm(); };
        for (const std::vector<uint32_t>& side : thighs) callForeLeg(*std::ranges::min_element(side, {}, away));
    }

    void callForeLeg(uint32_t top)
    {
        for (uint32_t b = top; b < tree_.size(); ++b)
            if (tree_.isBelow(static_cast<int32_t>(b), top)) anatomy_[b].part = ofForeLeg(anatomy_[b].part);
    }

    uint32_t firstOf(BodyPart part) const
    {
        const auto found = std::ranges::find(anatomy_, part, &BoneAnatomy::part);
        return static_cast<uint32_t>(found - anatomy_.begin());
    }

    void call(uint32_t b, BodyPart part) { anatomy_[b].part = part, anatomy_[b].source = AnatomySource::Name; }

    /// If no bone is called hips, they are the bone that carries the thighs: a root, or the first of a spine. No spine
    /// is above them.
    void findHips()
    {
        const uint32_t thigh = firstOf(BodyPart::Thigh);
        uint32_t hips = firstOf(BodyPart::Hips);
        if (hips == tree_.size() && thigh < tree_.size()) {
            const int32_t carrier = tree_.above(
                thigh, [&](uint32_t b) { return names_[b].side == 0 && !names_[b].isAttached && tree_.deforms[b]; });
            hips = carrier < 0 ? lowestSpine(thigh) : static_cast<uint32_t>(carrier);
            if (hips == tree_.size() || names_[hips].part == NamedPart::Head) return;
            call(hips, BodyPart::Hips);
        }
        for (int32_t b = hips < tree_.size() ? tree_.parents[hips] : -1; b >= 0; b = tree_.parents[b])
            if (anatomy_[b].part == BodyPart::Spine) anatomy_[b].part = BodyPart::Other;
    }

    /// Bones between hips and neck are spine, whatever their names.
    void closeSpine()
    {
        const auto isTrunk = [&](uint32_t b) {
            const BodyPart part = anatomy_[b].part;
            return part == BodyPart::Hips || part == BodyPart::Spine || part == BodyPart::Neck;
        };
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const int32_t parent = tree_.parents[b];
            const bool open = anatomy_[b].part == BodyPart::Other && names_[b].side == 0 && tree_.deforms[b];
            if (!open || parent < 0 || !isTrunk(static_cast<uint32_t>(parent))) continue;
            const auto goesOn = [&](uint32_t other) {
                return isTrunk(other) && anatomy_[other].part != BodyPart::Hips;
            };
            if (tree_.below(b, goesOn) >= 0) call(b, BodyPart::Spine);
        }
    }

    /// The first bone of a spine that has skin, of several the one nearest to a thigh; the number of bones for none.
    uint32_t lowestSpine(uint32_t thigh) const
    {
        uint32_t lowest = tree_.size();
        const auto away = [&](uint32_t b) { return (tree_.heads[b] - tree_.heads[thigh]).norm(); };
        const auto isSpine = [&](uint32_t b) { return anatomy_[b].part == BodyPart::Spine && tree_.deforms[b]; };
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const bool first = isSpine(b) && tree_.above(b, isSpine) < 0;
            if (first && (lowest == tree_.size() || away(b) < away(lowest))) lowest = b;
        }
        return lowest;
    }

    /// In a spine that does not carry the arms, the bones above them are the neck, and the highest the head.
    void findHeadAbove(uint32_t arm)
    {
        const auto height = [&](uint32_t b) { return tree_.heads[b].y(); };
        const uint32_t hips = firstOf(BodyPart::Hips);
        if (hips == tree_.size() || height(arm) < height(hips) + TRUNK * sizeOf(tree_)) return;
        uint32_t highest = tree_.size();
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            if (anatomy_[b].part != BodyPart::Spine || !tree_.deforms[b] || height(b) <= height(arm)) continue;
            call(b, BodyPart::Neck);
            if (highest == tree_.size() || height(b) > height(highest)) highest = b;
        }
        if (highest < tree_.size()) call(highest, BodyPart::Head);
    }

    /// If no bone is called head, a spine that continues past the last shoulders is the neck, with the head at its end.
    void findHead()
    {
        if (firstOf(BodyPart::Head) < tree_.size()) return;
        const auto isSpine = [&](uint32_t b) { return anatomy_[b].part == BodyPart::Spine; };
        const auto goesOn = [&](uint32_t b) { return isSpine(b) || anatomy_[b].part == BodyPart::Neck; };
        const std::vector<uint32_t> depths = tree_.depths();
        uint32_t arm = tree_.size();
        int32_t last = -1;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            if (anatomy_[b].part != BodyPart::Clavicle && anatomy_[b].part != BodyPart::UpperArm) continue;
            arm = std::min(arm, b);
            const int32_t on = tree_.above(b, isSpine);
            if (on >= 0 && (last < 0 || depths[on] > depths[last])) last = on;
        }
        if (arm < tree_.size() && last < 0) findHeadAbove(arm);
        while (last >= 0) {
            const auto next = std::ranges::find_if(tree_.children[last], goesOn);
            if (next == tree_.children[last].end()) break;
            last = static_cast<int32_t>(*next);
            call(*next, BodyPart::Neck);
        }
        if (last >= 0 && anatomy_[last].part == BodyPart::Neck) call(static_cast<uint32_t>(last), BodyPart::Head);
    }

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    std::vector<BoneAnatomy>& anatomy_;
};

}  // namespace

BodyPart partAbove(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t bone)
{
    const int32_t above = tree.above(bone, [&](uint32_t other) {
        return anatomy[other].part != BodyPart::Other && anatomy[other].side == anatomy[bone].side;
    });
    return above < 0 ? BodyPart::Other : anatomy[above].part;
}

int32_t spineAt(const BoneTree& tree, const std::vector<BoneAnatomy>& anatomy, uint32_t arm)
{
    int32_t nearest = -1, below = -1;
    const auto away = [&](int32_t b) { return b < 0 ? INFINITY : (tree.heads[b] - tree.heads[arm]).norm(); };
    for (uint32_t b = 0; b < tree.size(); ++b) {
        if (anatomy[b].part != BodyPart::Spine || anatomy[b].role != BoneRole::Limb || !tree.deforms[b]) continue;
        const auto spine = static_cast<int32_t>(b);
        if (away(spine) < away(nearest)) nearest = spine;
        if (tree.heads[b].y() < tree.heads[arm].y() && away(spine) < away(below)) below = spine;
    }
    return below < 0 ? nearest : below;
}

void readFigure(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
{
    FigureParts(tree, names, anatomy).read();
}

}  // namespace knuckle
