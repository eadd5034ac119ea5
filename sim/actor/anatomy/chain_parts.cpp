#include "sim/actor/anatomy/chain_parts.h"

#include <algorithm>

namespace knuckle {

namespace {

/// What the names of a skeleton say, bone by bone from the root.
class NamedParts {
public:
    NamedParts(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
        : tree_(tree), names_(names), anatomy_(anatomy)
    {
    }

    void read()
    {
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            anatomy_[b].side = sideOf(b);
            if (names_[b].part == NamedPart::None || !speaks(b)) continue;
            anatomy_[b].part = partOf(b);
            if (anatomy_[b].part != BodyPart::Other) anatomy_[b].source = AnatomySource::Name;
        }
        callLevers();
        callForeLegs();
        findHips();
        findHead();
    }

private:
    /// Twists and what is attached say nothing about the bones around them.
    bool speaks(uint32_t b) const
    {
        if (names_[b].isControl && !(tree_.hasSkin && tree_.deforms[b])) return false;
        return !names_[b].isAttached && !(names_[b].isTwist && repeats(b));
    }

    /// Whether a limb's bone that is no twist has the same words: a neck's twists may be all of it.
    bool repeats(uint32_t b) const
    {
        const BoneName& own = names_[b];
        if (own.side != 0) return true;
        for (uint32_t other = 0; other < tree_.size(); ++other)
            if (names_[other].part == own.part && (!names_[other].isTwist || other < b)) return true;
        return own.part == NamedPart::None;
    }

    /// A finger without a side is of the hand's.
    int sideOf(uint32_t b) const
    {
        if (names_[b].side != 0 || tree_.parents[b] < 0) return names_[b].side;
        const BoneAnatomy& parent = anatomy_[tree_.parents[b]];
        return isLimbPart(parent.part) ? parent.side : 0;
    }

    BodyPart partAbove(uint32_t b) const
    {
        const int32_t above = tree_.above(b, [&](uint32_t other) {
            return anatomy_[other].part != BodyPart::Other && anatomy_[other].side == anatomy_[b].side;
        });
        return above < 0 ? BodyPart::Other : anatomy_[above].part;
    }

    int32_t nextBelow(uint32_t b) const
    {
        return tree_.below(b, [&](uint32_t other) {
            const BoneName& name = names_[other];
            const bool sameSide = name.side == names_[b].side || name.side == 0;
            return sameSide && name.part != NamedPart::None && name.part != NamedPart::Spine && !name.isTwist &&
                   !name.isControl && !name.isAttached;
        });
    }

    NamedPart nameBelow(uint32_t b) const
    {
        const int32_t below = nextBelow(b);
        return below < 0 ? NamedPart::None : names_[below].part;
    }

    bool isUpperLeg(uint32_t leg) const
    {
        const NamedPart below = nameBelow(leg);
        return below == NamedPart::Shin || below == NamedPart::Leg;
    }

    BodyPart hipPart(uint32_t b) const
    {
        if (names_[b].side == 0) return BodyPart::Hips;
        const int32_t below = nextBelow(b);
        const NamedPart next = nameBelow(b);
        const bool thighBelow = next == NamedPart::Thigh || next == NamedPart::Hip ||
                                (next == NamedPart::Leg && isUpperLeg(static_cast<uint32_t>(below)));
        return thighBelow ? BodyPart::Other : BodyPart::Thigh;
    }

    BodyPart coxaPart(uint32_t b) const
    {
        const NamedPart below = nameBelow(b);
        return below == NamedPart::Shin || below == NamedPart::Foot ? BodyPart::Thigh : BodyPart::Coxa;
    }

    BodyPart shoulderPart(uint32_t b) const
    {
        const int32_t next = nextBelow(b);
        const NamedPart below = nameBelow(b);
        const BodyPart above = partAbove(b);
        const bool legBelow = below == NamedPart::Thigh ||
                              (below == NamedPart::Leg && isUpperLeg(static_cast<uint32_t>(next)));
        const bool armBelow = legBelow || below == NamedPart::UpperArm || below == NamedPart::Arm ||
                              below == NamedPart::Shoulder;
        if (armBelow || (below == NamedPart::None && above != BodyPart::Clavicle && above != BodyPart::UpperArm))
            return BodyPart::Clavicle;
        return BodyPart::UpperArm;
    }

    BodyPart armPart(uint32_t b) const
    {
        const BodyPart above = partAbove(b);
        if (above == BodyPart::UpperArm || above == BodyPart::Forearm) return BodyPart::Forearm;
        const NamedPart below = nameBelow(b);
        return below == NamedPart::UpperArm || below == NamedPart::Shoulder ? BodyPart::Clavicle : BodyPart::UpperArm;
    }

    BodyPart legPart(uint32_t b) const
    {
        const BodyPart above = partAbove(b);
        if (above == BodyPart::UpperArm || above == BodyPart::Forearm) return BodyPart::Forearm;
        return above == BodyPart::Thigh || above == BodyPart::Shin ? BodyPart::Shin : BodyPart::Thigh;
    }

    BodyPart fingerPart(uint32_t b) const
    {
        const BodyPart above = partAbove(b);
        const bool behindHand = above == BodyPart::Hand || above == BodyPart::Finger || above == BodyPart::Forearm;
        return behindHand ? BodyPart::Finger : BodyPart::Other;
    }

    BodyPart footPart(uint32_t b) const
    {
        const BodyPart above = partAbove(b);
        if (names_[b].part == NamedPart::Foot)
            return above == BodyPart::Foot || above == BodyPart::Toe ? BodyPart::Toe : BodyPart::Foot;
        const bool behindFoot = above == BodyPart::Foot || above == BodyPart::Toe || above == BodyPart::Shin;
        return behindFoot || names_[b].side != 0 ? BodyPart::Toe : BodyPart::Other;
    }

    BodyPart partOf(uint32_t b) const
    {
        const bool middle = names_[b].side == 0;
        switch (names_[b].part) {
            case NamedPart::None: return BodyPart::Other;
            case NamedPart::Hips: return middle ? BodyPart::Hips : BodyPart::Other;
            case NamedPart::Hip: return hipPart(b);
            case NamedPart::Spine: return middle ? BodyPart::Spine : BodyPart::Other;
            case NamedPart::Neck: return BodyPart::Neck;
            case NamedPart::Head: return BodyPart::Head;
            case NamedPart::Clavicle: return BodyPart::Clavicle;
            case NamedPart::Shoulder: return shoulderPart(b);
            case NamedPart::Arm: return armPart(b);
            case NamedPart::UpperArm: return BodyPart::UpperArm;
            case NamedPart::Forearm: return BodyPart::Forearm;
            case NamedPart::Hand: return BodyPart::Hand;
            case NamedPart::Finger: return BodyPart::Finger;
            case NamedPart::MaybeFinger: return fingerPart(b);
            case NamedPart::Leg: return legPart(b);
            case NamedPart::Coxa: return coxaPart(b);
            case NamedPart::Thigh: return BodyPart::Thigh;
            case NamedPart::Shin: return BodyPart::Shin;
            case NamedPart::Foot:
            case NamedPart::Toe: return footPart(b);
            case NamedPart::Tail: return BodyPart::Tail;
            case NamedPart::Wing: return BodyPart::Wing;
            case NamedPart::Lever: return BodyPart::Lever;
        }
        return BodyPart::Other;
    }

    /// Arms without a side of what has no legs and no head are a machine's.
    void callLevers()
    {
        const auto isAnimals = [](const BoneAnatomy& bone) {
            const bool arm = ofForeLeg(bone.part) == bone.part && isLimbPart(bone.part) && bone.part != BodyPart::Toe;
            return bone.part == BodyPart::Hips || bone.part == BodyPart::Neck || bone.part == BodyPart::Head ||
                   (isLimbPart(bone.part) && (bone.side != 0 || !arm));
        };
        if (std::ranges::any_of(anatomy_, isAnimals)) return;
        for (BoneAnatomy& bone : anatomy_)
            if (isLimbPart(bone.part)) bone.part = BodyPart::Lever;
    }

    /// Four legs, of which the front ones are arms: what hangs on a shoulder, or of two on a side the one next to the
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

    /// What carries the thighs, where nothing is called hips: a root, or the first of a spine. No spine is above them.
    void findHips()
    {
        const uint32_t thigh = firstOf(BodyPart::Thigh);
        uint32_t hips = firstOf(BodyPart::Hips);
        if (hips == tree_.size() && thigh < tree_.size()) {
            const int32_t carrier = tree_.above(
                thigh, [&](uint32_t b) { return names_[b].side == 0 && !names_[b].isAttached && tree_.deforms[b]; });
            if (carrier < 0 || names_[carrier].part == NamedPart::Head) return;
            hips = static_cast<uint32_t>(carrier);
            call(hips, BodyPart::Hips);
        }
        for (int32_t b = hips < tree_.size() ? tree_.parents[hips] : -1; b >= 0; b = tree_.parents[b])
            if (anatomy_[b].part == BodyPart::Spine) anatomy_[b].part = BodyPart::Other;
    }

    /// A spine that goes on past the shoulders, where nothing is called head: neck, and head at its end.
    void findHead()
    {
        if (firstOf(BodyPart::Head) < tree_.size()) return;
        const uint32_t arm = std::min(firstOf(BodyPart::Clavicle), firstOf(BodyPart::UpperArm));
        if (arm == tree_.size()) return;
        const auto isSpine = [&](uint32_t b) { return anatomy_[b].part == BodyPart::Spine; };
        const auto goesOn = [&](uint32_t b) { return isSpine(b) || anatomy_[b].part == BodyPart::Neck; };
        int32_t last = tree_.above(arm, isSpine);
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

void readNamedParts(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
{
    NamedParts(tree, names, anatomy).read();
}

BodyPart ofForeLeg(BodyPart part)
{
    switch (part) {
        case BodyPart::Thigh: return BodyPart::UpperArm;
        case BodyPart::Shin: return BodyPart::Forearm;
        case BodyPart::Foot: return BodyPart::Hand;
        default: return part;
    }
}

bool isLimbPart(BodyPart part)
{
    switch (part) {
        case BodyPart::Clavicle:
        case BodyPart::UpperArm:
        case BodyPart::Forearm:
        case BodyPart::Hand:
        case BodyPart::Finger:
        case BodyPart::Thigh:
        case BodyPart::Shin:
        case BodyPart::Foot:
        case BodyPart::Toe:
        case BodyPart::Coxa: return true;
        default: return false;
    }
}

}  // namespace knuckle
