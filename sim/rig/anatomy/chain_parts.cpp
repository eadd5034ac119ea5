#include "sim/rig/anatomy/chain_parts.h"

#include "sim/rig/anatomy/figure_parts.h"

namespace knuckle {

namespace {

/// Reads parts from the names of a skeleton, bone by bone from the root.
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
    }

private:
    /// Whether a bone says something about the bones around it; twists and attached bones do not.
    bool speaks(uint32_t b) const
    {
        if (names_[b].isControl && !(tree_.hasSkin && tree_.deforms[b])) return false;
        return (!names_[b].isAttached || carriesLimb(b)) && !(names_[b].isTwist && repeats(b));
    }

    /// Whether a bone named after a muscle or clothes is the upper half of a limb.
    bool carriesLimb(uint32_t b) const
    {
        const NamedPart own = names_[b].part, below = nameBelow(b);
        if (own == NamedPart::UpperArm) return below == NamedPart::Forearm && partAbove(b) != BodyPart::UpperArm;
        return own == NamedPart::Thigh && below == NamedPart::Shin && partAbove(b) != BodyPart::Thigh;
    }

    /// Whether a limb's bone that is no twist has the same words: the twists of a neck may be all of it.
    bool repeats(uint32_t b) const
    {
        const BoneName& own = names_[b];
        if (own.side != 0) return true;
        for (uint32_t other = 0; other < tree_.size(); ++other)
            if (names_[other].part == own.part && (!names_[other].isTwist || other < b)) return true;
        return own.part == NamedPart::None;
    }

    /// A finger without a side has the hand's.
    int sideOf(uint32_t b) const
    {
        if (names_[b].side != 0 || tree_.parents[b] < 0) return names_[b].side;
        const BoneAnatomy& parent = anatomy_[tree_.parents[b]];
        return isLimbPart(parent.part) ? parent.side : 0;
    }

    BodyPart partAbove(uint32_t b) const { return knuckle::partAbove(tree_, anatomy_, b); }

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
        if (names_[b].side == 0 && !hasRival(b)) return BodyPart::Hips;
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
        if (above == BodyPart::Foot || above == BodyPart::Toe || above == BodyPart::Hand) return BodyPart::Toe;
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

    /// Whether both sides, neck or head are below a bone of neither side, so that it belongs to the trunk.
    bool isCentral(uint32_t b) const
    {
        if (names_[b].side != 0) return false;
        const auto has = [&](const auto& fits) {
            return tree_.below(b, [&](uint32_t other) { return !names_[other].isAttached && fits(names_[other]); }) >=
                   0;
        };
        const auto upwards = [](const BoneName& name) {
            return name.part == NamedPart::Neck || name.part == NamedPart::Head;
        };
        return has(upwards) || (has([](const BoneName& name) { return name.side > 0; }) &&
                                has([](const BoneName& name) { return name.side < 0; }));
    }

    /// If there are two hips, each is one of a side.
    bool hasRival(uint32_t b) const
    {
        if (tree_.parents[b] < 0) return false;
        return std::ranges::any_of(tree_.children[tree_.parents[b]], [&](uint32_t other) {
            return other != b && names_[other].part == names_[b].part && !names_[other].isTwist;
        });
    }

    BodyPart partOf(uint32_t b) const
    {
        const bool middle = names_[b].side == 0;
        const NamedPart part = names_[b].part;
        const bool arm = part == NamedPart::Shoulder || part == NamedPart::Arm, leg = part == NamedPart::Leg;
        if ((arm || leg) && isCentral(b)) return arm ? BodyPart::Spine : BodyPart::Hips;
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

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    std::vector<BoneAnatomy>& anatomy_;
};

}  // namespace

void readNamedParts(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
{
    NamedParts(tree, names, anatomy).read();
    readFigure(tree, names, anatomy);
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
