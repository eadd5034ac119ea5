#include "sim/rig/anatomy/shape/shape_fill.h"

#include <algorithm>
#include <optional>

#include "sim/rig/anatomy/chain_parts.h"
#include "sim/rig/anatomy/shape/shape_parts.h"

namespace knuckle {

namespace {

enum class Limbs { None, Arm, Leg, Trunk, Other };

Limbs limbsOf(BodyPart part)
{
    switch (part) {
        case BodyPart::Clavicle:
        case BodyPart::UpperArm:
        case BodyPart::Forearm:
        case BodyPart::Hand:
        case BodyPart::Finger: return Limbs::Arm;
        case BodyPart::Coxa:
        case BodyPart::Thigh:
        case BodyPart::Shin:
        case BodyPart::Foot:
        case BodyPart::Toe: return Limbs::Leg;
        case BodyPart::Hips:
        case BodyPart::Spine:
        case BodyPart::Neck:
        case BodyPart::Head: return Limbs::Trunk;
        default: return part == BodyPart::Other ? Limbs::None : Limbs::Other;
    }
}

/// The skeleton without bones called hair, clothes or props: a cape is no limb. Bones on which most of it hangs stay.
BoneTree withoutAttached(BoneTree tree, const std::vector<BoneName>& names)
{
    std::vector<uint8_t> cut(tree.size(), 0);
    const auto speaks = [&](uint32_t b) { return names[b].part != NamedPart::None && !names[b].isAttached; };
    for (uint32_t b = 0; b < tree.size(); ++b) {
        const int32_t parent = tree.parents[b];
        cut[b] = parent >= 0 && cut[parent];
        if (cut[b] || !names[b].isAttached || tree.below(b, speaks) >= 0) continue;
        uint32_t below = 0;
        for (uint32_t other = 0; other < tree.size(); ++other) below += tree.isBelow(static_cast<int32_t>(other), b);
        cut[b] = 2 * below < tree.size();
    }
    for (uint32_t b = 0; b < tree.size(); ++b) tree.carries[b] &= !cut[b];
    return tree;
}

/// Adds the shape's parts to those from names.
class ShapeFill {
public:
    ShapeFill(const BoneTree& tree, const std::vector<BoneName>& names, const std::vector<BoneAnatomy>& shape,
              std::vector<BoneAnatomy>& anatomy)
        : tree_(tree), names_(names), shape_(shape), anatomy_(anatomy)
    {
    }

    void fill()
    {
        const bool none = std::ranges::none_of(anatomy_, isLimbPart, &BoneAnatomy::part);
        const bool arms = isOpen(Limbs::Arm, {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand}) &&
                          agrees(Limbs::Arm);
        const bool legs = isOpen(Limbs::Leg, {BodyPart::Thigh, BodyPart::Shin, BodyPart::Foot}) && agrees(Limbs::Leg);
        if (!arms && !legs) return;
        const auto has = [&](BodyPart part) {
            return std::ranges::find(anatomy_, part, &BoneAnatomy::part) != anatomy_.end();
        };
        const bool hips = has(BodyPart::Hips), head = has(BodyPart::Head);
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart part = shape_[b].part;
            const Limbs region = limbsOf(part);
            if (region == Limbs::None || !isSilent(b)) continue;
            const bool wanted = region == Limbs::Arm   ? arms
                                : region == Limbs::Leg ? legs
                                : region == Limbs::Trunk
                                    ? none || !((part == BodyPart::Hips && hips) || (part == BodyPart::Head && head))
                                    : none || legs;
            if (wanted) take(b);
        }
    }

private:
    void take(uint32_t b)
    {
        anatomy_[b].part = shape_[b].part;
        anatomy_[b].source = AnatomySource::Shape;
        if (anatomy_[b].side == 0) anatomy_[b].side = shape_[b].side;
    }

    /// Whether names leave a part of such limbs open, or all of them, and the shape knows a silent bone of them.
    bool isOpen(Limbs region, const std::vector<BodyPart>& whole) const
    {
        bool any = false, says = false;
        for (uint32_t b = 0; b < tree_.size(); ++b) says |= limbsOf(shape_[b].part) == region && isSilent(b);
        if (!says) return false;
        for (const int side : {1, -1, 0}) {
            const auto has = [&](const auto& fits) {
                return std::ranges::any_of(
                    anatomy_, [&](const BoneAnatomy& bone) { return bone.side == side && fits(bone.part); });
            };
            if (!has([&](BodyPart part) { return limbsOf(part) == region; })) continue;
            any = true;
            for (const BodyPart wanted : whole)
                if (!has([&](BodyPart part) { return part == wanted; })) return true;
        }
        return !any;
    }

    /// Whether the shape sees the named long limbs of a region, and contradicts no name in it.
    /// its name.
    bool agrees(Limbs region) const
    {
        using enum BodyPart;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart said = anatomy_[b].part, seen = shape_[b].part;
            const bool here = limbsOf(said) == region || limbsOf(seen) == region;
            const bool unseen = limbsOf(said) == region && isLongLimb(said) && !isLimbPart(seen) && tree_.deforms[b];
            if (unseen) return false;
            if (!here || said == Other || seen == Other || said == seen) continue;
            const auto isEnd = [](BodyPart part) {
                return part == Clavicle || part == Finger || part == Coxa || part == Toe;
            };
            if (limbsOf(said) != limbsOf(seen) || !(isEnd(said) || isEnd(seen))) return false;
        }
        return true;
    }

    /// Whether a bone's name does not say what it is. A bone named after clothes may be part of a trunk, or carry named
    /// bones.
    bool isSilent(uint32_t b) const
    {
        const BoneName& name = names_[b];
        if (anatomy_[b].part != BodyPart::Other || name.isTwist || name.isEnd) return false;
        if (name.isControl && !tree_.deforms[b]) return false;
        const bool carries = tree_.below(
                                 b, [&](uint32_t other) { return anatomy_[other].source == AnatomySource::Name; }) >= 0;
        return !name.isAttached || carries || limbsOf(shape_[b].part) == Limbs::Trunk;
    }

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    const std::vector<BoneAnatomy>& shape_;
    std::vector<BoneAnatomy>& anatomy_;
};

/// Gives limbs named without a side the side that they are on. @returns whether there are any.
bool takeSides(const std::vector<BoneAnatomy>& shape, std::vector<BoneName>& names)
{
    bool any = false;
    for (size_t b = 0; b < names.size(); ++b) {
        const Limbs region = limbsOf(shape[b].part);
        const bool limb = region == Limbs::Arm || region == Limbs::Leg;
        if (!limb || names[b].side != 0 || names[b].part == NamedPart::None) continue;
        names[b].side = shape[b].side;
        any |= shape[b].side != 0;
    }
    return any;
}

}  // namespace

std::vector<BoneAnatomy> readParts(const BoneTree& tree, std::vector<BoneName>& names)
{
    const BoneTree body = withoutAttached(tree, names);
    std::vector<BoneAnatomy> anatomy(tree.size());
    readNamedParts(tree, names, anatomy);
    std::vector<BoneAnatomy> shape = readShape(body, anatomy);
    if (takeSides(shape, names)) {
        anatomy.assign(tree.size(), {});
        readNamedParts(tree, names, anatomy);
        shape = readShape(body, anatomy);
    }
    ShapeFill(tree, names, shape, anatomy).fill();
    return anatomy;
}

}  // namespace knuckle
