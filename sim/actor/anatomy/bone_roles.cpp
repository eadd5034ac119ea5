#include "sim/actor/anatomy/bone_roles.h"

#include <algorithm>

#include "sim/actor/anatomy/chain_parts.h"
#include "sim/actor/anatomy/figure_parts.h"

namespace knuckle {

namespace {

/// A thigh on a spine belongs to the hips unless they are farther off than this [distance from the spine].
constexpr float NEARER_HIPS = 1.25f;
constexpr float SAME = 1e-3f;  // two bones that begin at one place [m]

class BoneRoles {
public:
    BoneRoles(const BoneTree& tree, const std::vector<BoneName>& names, const std::map<uint32_t, BoneRole>& wanted,
              std::vector<BoneAnatomy>& anatomy)
        : tree_(tree), names_(names), wanted_(wanted), anatomy_(anatomy), below_(tree.size(), 0)
    {
        for (uint32_t b = tree.size(); b-- > 0;)
            if (tree.carries[b] && tree.parents[b] >= 0) below_[tree.parents[b]] += below_[b] + 1;
    }

    void read()
    {
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const auto wish = wanted_.find(b);
            anatomy_[b].role = wish == wanted_.end() ? roleOf(b) : wish->second;
        }
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (const int32_t main = mainOf(b); main >= 0 && !wanted_.contains(b)) {
                anatomy_[b].role = BoneRole::Twist;
                anatomy_[b].owner = static_cast<uint32_t>(main);
            }
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (anatomy_[b].owner == NO_INDEX) anatomy_[b].owner = ownerOf(b);
        for (uint32_t b = 0; b < tree_.size(); ++b) anatomy_[b].parent = isLimb(b) ? parentOf(b) : -1;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            reattach(b);
            reattachToTrunk(b);
        }
    }

private:
    bool isLimb(uint32_t b) const { return anatomy_[b].role == BoneRole::Limb; }
    bool hasPart(uint32_t b) const { return anatomy_[b].part != BodyPart::Other; }

    BoneRole roleOf(uint32_t b) const
    {
        const BoneName& name = names_[b];
        if (!tree_.deforms[b] && !hasPart(b)) return BoneRole::Control;
        const auto counts = [&](uint32_t other) { return hasPart(other); };
        if (name.isEnd && tree_.below(b, [&](uint32_t other) { return tree_.carries[other] != 0; }) < 0)
            return BoneRole::Attached;
        const int32_t above = tree_.above(b, counts);
        const bool onHead = above >= 0 && anatomy_[above].part == BodyPart::Head;
        if (hasPart(b)) return continues(b) ? BoneRole::Twist : onHead ? BoneRole::Attached : BoneRole::Limb;
        const bool carriesParts = tree_.below(b, counts) >= 0;
        // A pelvis of one side, a hip that has a thigh below.
        const bool halfHip = name.side != 0 && (name.part == NamedPart::Hips || name.part == NamedPart::Spine ||
                                                (name.part == NamedPart::Hip && !name.isTwist));
        if (halfHip || (name.isAttached && !carriesParts)) return BoneRole::Attached;
        if (name.isTwist) return BoneRole::Twist;
        return onHead ? BoneRole::Attached : BoneRole::Limb;
    }

    /// A limb's second piece: "thigh.L.001" below "thigh.L", a hand below a wrist.
    bool continues(uint32_t b) const
    {
        const BodyPart part = anatomy_[b].part;
        const bool named = anatomy_[b].source == AnatomySource::Name;
        const bool numbered = names_[b].part == NamedPart::Leg || names_[b].part == NamedPart::Arm;
        if (!named || numbered || !isLimbPart(part) || part == BodyPart::Finger || part == BodyPart::Toe) return false;
        const int32_t above = tree_.above(b, [&](uint32_t other) { return hasPart(other); });
        return above >= 0 && anatomy_[above].part == part && anatomy_[above].side == anatomy_[b].side;
    }

    /// Of several bones of one part on one bone, the one that a helper or a piece of a palm belongs to; -1 for none.
    int32_t mainOf(uint32_t b) const
    {
        const BoneAnatomy& own = anatomy_[b];
        const bool limb = isLimbPart(own.part) && own.part != BodyPart::Finger && own.part != BodyPart::Toe;
        if (own.source != AnatomySource::Name || !isLimb(b) || !limb || tree_.parents[b] < 0) return -1;
        const uint32_t ownSize = below_[b];
        if (ownSize > 0 && own.part != BodyPart::Hand) return -1;
        int32_t main = -1;
        uint32_t most = ownSize;
        for (const uint32_t other : tree_.children[tree_.parents[b]]) {
            const BoneAnatomy& rival = anatomy_[other];
            if (other == b || !isLimb(other) || rival.part != own.part || rival.side != own.side) continue;
            const uint32_t size = below_[other];
            const bool wins = size > most || (size == most && main < 0 && other < b && own.part == BodyPart::Hand);
            if (!wins) continue;
            most = size;
            main = static_cast<int32_t>(other);
        }
        return main;
    }

    uint32_t ownerOf(uint32_t b) const
    {
        if (isLimb(b) || anatomy_[b].role == BoneRole::Control) return b;
        const auto limb = [&](uint32_t other) { return isLimb(other); };
        int32_t owner = tree_.above(b, limb);
        if (anatomy_[b].role == BoneRole::Twist && owner >= 0) owner = twisted(b, static_cast<uint32_t>(owner));
        const bool ofHips = owner < 0 && names_[b].part == NamedPart::Hips;
        if (ofHips) owner = nearestOf(BodyPart::Hips, 0, b);
        return owner < 0 ? nearestLimb(b) : static_cast<uint32_t>(owner);
    }

    /// In the skeleton, of equally near ones that nearest in space; the bone itself where there is none.
    uint32_t nearestLimb(uint32_t b) const
    {
        const std::vector<uint32_t> steps = tree_.stepsFrom(b);
        uint32_t nearest = b;
        for (uint32_t other = 0; other < tree_.size(); ++other)
            if (isLimb(other) && steps[other] != NO_INDEX &&
                (nearest == b || steps[other] < steps[nearest] ||
                 (steps[other] == steps[nearest] && apart(other, b) < apart(nearest, b))))
                nearest = other;
        return nearest;
    }

    /// The limb of a twist: of its side and, where it says so, of its part.
    int32_t twisted(uint32_t b, uint32_t above) const
    {
        const int side = anatomy_[b].side;
        const BodyPart part = partSaid(b);
        const bool fits = side == 0 || anatomy_[above].side == side;
        if (fits && (part == BodyPart::Other || part == anatomy_[above].part)) return static_cast<int32_t>(above);
        const int32_t beside = tree_.below(above, [&](uint32_t other) {
            return isLimb(other) && anatomy_[other].side == side &&
                   (part == BodyPart::Other || anatomy_[other].part == part);
        });
        return beside < 0 ? static_cast<int32_t>(above) : beside;
    }

    BodyPart partSaid(uint32_t b) const
    {
        switch (names_[b].part) {
            case NamedPart::Thigh: return BodyPart::Thigh;
            case NamedPart::Shin: return BodyPart::Shin;
            case NamedPart::UpperArm: return BodyPart::UpperArm;
            case NamedPart::Forearm: return BodyPart::Forearm;
            default: return BodyPart::Other;
        }
    }

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

    /// The limb that moves as a control does, for what hangs on that: it begins where the control does and is on it or
    /// of its name. -1 for none, and where the one that asks begins there itself.
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

    /// Feet and hands that hang on a control instead of their limb, fingers that hang beside their hand.
    void reattach(uint32_t b)
    {
        BoneAnatomy& own = anatomy_[b];
        if (!isLimb(b) || own.side == 0 || own.source != AnatomySource::Name) return;
        std::vector<BodyPart> wanted;
        if (own.part == BodyPart::Foot) wanted = {BodyPart::Shin, BodyPart::Thigh};
        if (own.part == BodyPart::Hand) wanted = {BodyPart::Forearm, BodyPart::UpperArm};
        if (own.part == BodyPart::Finger) wanted = {BodyPart::Hand, BodyPart::Finger};
        if (own.part == BodyPart::Shin) wanted = {BodyPart::Thigh};
        if (own.part == BodyPart::Forearm) wanted = {BodyPart::UpperArm};
        const bool onLimb = own.parent >= 0 && anatomy_[own.parent].side == own.side &&
                            (own.part != BodyPart::Finger || std::ranges::count(wanted, anatomy_[own.parent].part));
        if (onLimb) return;
        for (const BodyPart part : wanted) {
            const int32_t nearest = nearestOf(part, own.side, b);
            if (nearest < 0) continue;
            own.parent = nearest;
            return;
        }
    }

    /// The limb of a part and side nearest in space that does not hang on the bone itself; -1 for none.
    int32_t nearestOf(BodyPart part, int side, uint32_t b) const
    {
        int32_t nearest = -1;
        for (uint32_t other = 0; other < tree_.size(); ++other) {
            const BoneAnatomy& limb = anatomy_[other];
            const bool fits = limb.part == part && limb.side == side && isLimb(other);
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
        if (!isLimb(b) || own.source != AnatomySource::Name) return;
        if (own.parent < 0) own.parent = onTrunk(b);
        if (own.parent < 0) return;
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

    /// Where a limb belongs whose bones hang on none with skin; -1 where nothing is called so.
    int32_t onTrunk(uint32_t b) const
    {
        const BoneAnatomy& own = anatomy_[b];
        int32_t on = -1;
        switch (own.part) {
            case BodyPart::Thigh: return nearestOf(BodyPart::Hips, 0, b);
            case BodyPart::Spine:
            case BodyPart::Neck:
            case BodyPart::Head: on = nearerToHips(b); break;
            case BodyPart::UpperArm: on = nearestOf(BodyPart::Clavicle, own.side, b); [[fallthrough]];
            case BodyPart::Clavicle: on = on < 0 ? spineAt(tree_, anatomy_, b) : on; break;
            default: break;
        }
        return on >= 0 && hangsOn(on, b) ? -1 : on;
    }

    /// Of the trunk between a bone and the hips the nearest; -1 for none.
    int32_t nearerToHips(uint32_t b) const
    {
        const int32_t hips = nearestOf(BodyPart::Hips, 0, b);
        if (hips < 0) return -1;
        const auto fromHips = [&](uint32_t bone) { return apart(bone, static_cast<uint32_t>(hips)); };
        int32_t nearest = hips;
        for (uint32_t other = 0; other < tree_.size(); ++other) {
            const BodyPart part = anatomy_[other].part;
            const bool trunk = isLimb(other) && (part == BodyPart::Spine || part == BodyPart::Neck);
            if (trunk && fromHips(other) < fromHips(b) && apart(other, b) < apart(static_cast<uint32_t>(nearest), b))
                nearest = static_cast<int32_t>(other);
        }
        return nearest;
    }

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    const std::map<uint32_t, BoneRole>& wanted_;
    std::vector<BoneAnatomy>& anatomy_;
    std::vector<uint32_t> below_;  ///< Per bone, how many with skin are below.
};

}  // namespace

void readRoles(const BoneTree& tree, const std::vector<BoneName>& names, const std::map<uint32_t, BoneRole>& wanted,
               std::vector<BoneAnatomy>& anatomy)
{
    BoneRoles(tree, names, wanted, anatomy).read();
}

}  // namespace knuckle
