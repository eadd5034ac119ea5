#include "sim/rig/anatomy/bone_parents.h"

#include <algorithm>

#include "sim/rig/anatomy/chain_parts.h"
#include "sim/rig/anatomy/figure_parts.h"
#include "sim/rig/anatomy/limb_ends.h"

namespace knuckle {

namespace {

/// A thigh on a spine belongs to the hips unless they are further off than this [distance from the spine].
constexpr float NEARER_HIPS = 1.25f;
constexpr float SAME = 1e-3f;  // two bones that begin at one place [m]

class BoneParents {
public:
    BoneParents(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
        : tree_(tree), names_(names), anatomy_(anatomy), hasBody_(tree.size(), 0)
    {
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (tree_.deforms[b] && anatomy_[b].owner != NO_INDEX) hasBody_[anatomy_[b].owner] = 1;
    }

    void read()
    {
        for (uint32_t b = 0; b < tree_.size(); ++b) anatomy_[b].parent = isLimb(b) ? parentOf(b) : -1;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            reattach(b);
            reattachToTrunk(b);
        }
    }

private:
    bool isLimb(uint32_t b) const { return anatomy_[b].role == BoneRole::Limb; }

    int32_t parentOf(uint32_t b) const
    {
        for (int32_t above = tree_.parents[b]; above >= 0; above = tree_.parents[above]) {
            const BoneAnatomy& bone = anatomy_[above];
            const int32_t limb = bone.role == BoneRole::Control ? standIn(static_cast<uint32_t>(above), b)
                                                                : static_cast<int32_t>(bone.owner);
            if (limb >= 0 && !tree_.isBelow(limb, b) && !hangsOn(limb, b)) return limb;
        }
        return -1;
    }

    /// The limb that moves like a control, for bones that hang on the control: it begins at the same place, and hangs
    /// on the control or has its name. -1 for none, or if the asking bone begins there itself.
    int32_t standIn(uint32_t control, uint32_t asks) const
    {
        if (apart(asks, control) < SAME) return -1;
        const BoneName& name = names_[control];
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const bool alike = name.part != NamedPart::None && names_[b].part == name.part &&
                               names_[b].side == name.side;
            const bool onIt = tree_.parents[b] == static_cast<int32_t>(control);
            if ((alike || onIt) && isLimb(b) && apart(b, control) < SAME) return static_cast<int32_t>(b);
        }
        return -1;
    }

    float apart(uint32_t a, uint32_t b) const { return (tree_.heads[a] - tree_.heads[b]).norm(); }

    bool hangsOn(int32_t bone, uint32_t ancestor) const
    {
        while (bone >= 0 && bone != static_cast<int32_t>(ancestor)) bone = anatomy_[bone].parent;
        return bone >= 0;
    }

    /// Reattaches feet and hands that hang on a control instead of their limb, and fingers that hang beside their hand.
    void reattach(uint32_t b)
    {
        using enum BodyPart;
        BoneAnatomy& own = anatomy_[b];
        if (!isLimb(b) || own.side == 0 || !isEnd(b)) return;
        const bool isFinger = own.part == Finger;
        const BodyPart on = own.parent < 0 ? Other : anatomy_[own.parent].part;
        const bool onLimb = own.parent >= 0 && anatomy_[own.parent].side == own.side &&
                            (!isFinger || on == Hand || on == Finger);
        if (onLimb) return;
        int32_t limb = limbOfEnd(tree_, names_, anatomy_, hasBody_, b, own.part);
        if (limb < 0 && isFinger) limb = nearestOf(Finger, own.side, b);
        if (limb < 0 && own.part == Toe) {
            limb = limbOfEnd(tree_, names_, anatomy_, hasBody_, b, Foot);
            if (limb >= 0) own.part = Foot;
        }
        if (limb < 0) return;
        own.parent = limb;
        const BodyPart part = anatomy_[limb].part;
        if (own.part == Other) own.part = Foot, own.source = AnatomySource::Shape;
        if (part == UpperArm || part == Forearm) own.part = ofForeLeg(own.part);
    }

    /// Whether a bone belongs at the end of a limb, by its name, or perhaps as a leaf that hangs on nothing.
    bool isEnd(uint32_t b) const
    {
        using enum BodyPart;
        const BoneAnatomy& own = anatomy_[b];
        if (own.part == Other)
            return own.source == AnatomySource::None && isAdrift(b) &&
                   std::ranges::count(anatomy_, static_cast<int32_t>(b), &BoneAnatomy::parent) == 0;
        return own.source == AnatomySource::Name && (own.part == Foot || own.part == Hand || own.part == Finger ||
                                                     own.part == Toe || own.part == Shin || own.part == Forearm);
    }

    /// The limb of a part and side nearest in space that does not hang on the bone itself; -1 for none.
    int32_t nearestOf(BodyPart part, int side, uint32_t b) const
    {
        int32_t nearest = -1;
        for (uint32_t other = 0; other < tree_.size(); ++other) {
            const BoneAnatomy& limb = anatomy_[other];
            const bool fits = limb.part == part && limb.side == side && isLimb(other) && hasBody_[other];
            if (!fits || hangsOn(static_cast<int32_t>(other), b)) continue;
            if (nearest < 0 || apart(other, b) < apart(static_cast<uint32_t>(nearest), b))
                nearest = static_cast<int32_t>(other);
        }
        return nearest;
    }

    /// Biped hangs thighs on the spine and collar bones on the neck; others hang thighs on no bone with skin.
    void reattachToTrunk(uint32_t b)
    {
        BoneAnatomy& own = anatomy_[b];
        if (!isLimb(b)) return;
        if (isAdrift(b))
            if (const int32_t trunk = onTrunk(b); trunk >= 0) own.parent = trunk;
        if (own.parent < 0 || own.source != AnatomySource::Name) return;
        const auto parent = static_cast<uint32_t>(own.parent);
        const int32_t above = anatomy_[parent].parent;
        if (above < 0) return;
        const BodyPart on = anatomy_[parent].part, beyond = anatomy_[above].part;
        const bool thigh = own.part == BodyPart::Thigh && on == BodyPart::Spine && beyond == BodyPart::Hips &&
                           apart(static_cast<uint32_t>(above), b) < NEARER_HIPS * apart(parent, b);
        const bool arm = (own.part == BodyPart::Clavicle || own.part == BodyPart::UpperArm) && on == BodyPart::Neck &&
                         beyond == BodyPart::Spine;
        if (thigh || arm) own.parent = above;
    }

    /// Whether a limb hangs on no limb that has skin.
    bool isAdrift(uint32_t b) const
    {
        int32_t above = anatomy_[b].parent;
        while (above >= 0 && !hasBody_[above]) above = anatomy_[above].parent;
        return above < 0 && hasBody_[b];
    }

    /// The limb of the trunk for a limb whose bones hang on none with skin; -1 if no name tells it.
    int32_t onTrunk(uint32_t b) const
    {
        const BoneAnatomy& own = anatomy_[b];
        int32_t on = -1;
        switch (own.part) {
            case BodyPart::Thigh:
            case BodyPart::Coxa:
                on = nearestOf(BodyPart::Hips, 0, b);
                on = on < 0 ? nearestOf(BodyPart::Spine, 0, b) : on;
                break;
            case BodyPart::Spine:
            case BodyPart::Neck:
            case BodyPart::Head: on = nearerToHips(b); break;
            case BodyPart::UpperArm: on = nearestOf(BodyPart::Clavicle, own.side, b); [[fallthrough]];
            case BodyPart::Clavicle: on = on < 0 ? spineAt(tree_, anatomy_, b) : on; break;
            default: break;
        }
        return on >= 0 && hangsOn(on, b) ? -1 : on;
    }

    /// The nearest bone of the trunk between a bone and the hips; -1 for none.
    int32_t nearerToHips(uint32_t b) const
    {
        const int32_t hips = nearestOf(BodyPart::Hips, 0, b);
        if (hips < 0) return -1;
        const auto fromHips = [&](uint32_t bone) { return apart(bone, static_cast<uint32_t>(hips)); };
        int32_t nearest = hips;
        for (uint32_t other = 0; other < tree_.size(); ++other) {
            const BodyPart part = anatomy_[other].part;
            const bool trunk = isLimb(other) && hasBody_[other] && (part == BodyPart::Spine || part == BodyPart::Neck);
            if (trunk && fromHips(other) < fromHips(b) && apart(other, b) < apart(static_cast<uint32_t>(nearest), b))
                nearest = static_cast<int32_t>(other);
        }
        return nearest;
    }

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    std::vector<BoneAnatomy>& anatomy_;
    std::vector<uint8_t> hasBody_;  ///< Whether a limb, or a part of it, has skin.
};

}  // namespace

void readParents(const BoneTree& tree, const std::vector<BoneName>& names, std::vector<BoneAnatomy>& anatomy)
{
    BoneParents(tree, names, anatomy).read();
}

}  // namespace knuckle
