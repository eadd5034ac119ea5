#include "sim/rig/anatomy/bone_roles.h"

#include <algorithm>

#include "sim/rig/anatomy/bone_parents.h"
#include "sim/rig/anatomy/chain_parts.h"

namespace knuckle {

namespace {

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
        readParents(tree_, names_, anatomy_);
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
        // A pelvis of one side is a hip with a thigh below.
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

    /// Of several bones of one part on one bone, the main one, which helpers or pieces of a palm belong to; -1 for
    /// none.
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
        if (ofHips) owner = nearestHips(b);
        return owner < 0 ? nearestLimb(b) : static_cast<uint32_t>(owner);
    }

    /// Nearest in the skeleton, of equally near ones that nearest in space; the bone itself if there is none.
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

    /// The limb of a twist: of its side and, if its name says one, of its part.
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

    float apart(uint32_t a, uint32_t b) const { return (tree_.heads[a] - tree_.heads[b]).norm(); }

    /// The nearest hips in space; -1 for none.
    int32_t nearestHips(uint32_t b) const
    {
        int32_t nearest = -1;
        for (uint32_t other = 0; other < tree_.size(); ++other) {
            const bool hips = anatomy_[other].part == BodyPart::Hips && anatomy_[other].side == 0 && isLimb(other);
            if (hips && (nearest < 0 || apart(other, b) < apart(static_cast<uint32_t>(nearest), b)))
                nearest = static_cast<int32_t>(other);
        }
        return nearest;
    }

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    const std::map<uint32_t, BoneRole>& wanted_;
    std::vector<BoneAnatomy>& anatomy_;
    std::vector<uint32_t> below_;  ///< Per bone, how many bones below have skin.
};

}  // namespace

void readRoles(const BoneTree& tree, const std::vector<BoneName>& names, const std::map<uint32_t, BoneRole>& wanted,
               std::vector<BoneAnatomy>& anatomy)
{
    BoneRoles(tree, names, wanted, anatomy).read();
}

}  // namespace knuckle
