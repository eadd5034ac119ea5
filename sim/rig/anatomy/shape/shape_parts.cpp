#include "sim/rig/anatomy/shape/shape_parts.h"

#include <algorithm>
#include <cmath>

#include "sim/rig/anatomy/chain_parts.h"
#include "sim/rig/anatomy/shape/limb_pairs.h"

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float GROUND = 0.2f;     // ends of legs are at most this far above the lowest [height]
constexpr float DOWN = 0.3f;       // ... and begin this far above their ends [length]
constexpr float FOOT = 0.2f;       // a foot begins at most this far above the ground [height of the leg]
constexpr float SHORT = 0.45f;     // a shorter first bone of a leg is part of the hip [next one]
constexpr size_t MOST_NECKS = 3;   // of a chain up to the head
constexpr size_t PONYTAIL = 2;     // its bones at least
constexpr float ARM = 0.75f;       // the usual length of arms [length of legs]
constexpr float ALIKE = 0.1f;      // logarithm of the ratio of two pairs' lengths that are both arms
constexpr float LONG_WING = 0.2f;  // shorter pairs are feelers and ears [size]

class ShapeParts {
public:
    ShapeParts(const BoneTree& tree, const MirrorPlane& plane, const std::vector<BoneAnatomy>& named,
               std::vector<BoneAnatomy>& anatomy)
        : tree_(tree), plane_(plane), named_(named), anatomy_(anatomy), trunk_(tree.size(), 0), inPair_(tree.size(), 0)
    {
    }

    void read()
    {
        sortPairs();
        if (legs_.empty()) return;
        pelvis_ = legs_.front().base;
        markTrunk();
        readEnds();
        readPairs();
        call(pelvis_, BodyPart::Hips);
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (trunk_[b]) call(b, BodyPart::Spine);
        readSides();
    }

private:
    void call(uint32_t b, BodyPart part)
    {
        if (anatomy_[b].source != AnatomySource::None) return;
        anatomy_[b].part = part;
        anatomy_[b].source = AnatomySource::Shape;
    }

    void callBelow(uint32_t top, BodyPart part)
    {
        for (uint32_t b = top + 1; b < tree_.size(); ++b)
            if (tree_.carries[b] && tree_.isBelow(static_cast<int32_t>(b), top)) call(b, part);
    }

    void sortPairs()
    {
        Eigen::AlignedBox3f box;
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (tree_.carries[b] && tree_.deforms[b]) box.extend(tree_.heads[b]).extend(tree_.tips[b]);
        for (LimbPair& pair : findLimbPairs(tree_, plane_)) {
            const bool inAnother = std::ranges::any_of(pair.chains, [&](const BoneChain& chain) {
                return tree_.above(chain.bones.front(), [&](uint32_t b) { return inPair_[b] != 0; }) >= 0;
            });
            if (inAnother) continue;
            for (const BoneChain& chain : pair.chains)
                for (const uint32_t b : chain.bones) inPair_[b] = 1;
            const bool atGround = pair.lowest < box.min().y() + GROUND * box.sizes().y();
            const bool goesDown = tree_.heads[pair.chains[0].bones.front()].y() > pair.lowest + DOWN * pair.length();
            (atGround && goesDown && pair.count() >= 3 ? legs_ : others_).push_back(std::move(pair));
        }
    }

    /// Marks the ways from the pelvis to the bones that other limbs hang on.
    void markTrunk()
    {
        for (const std::vector<LimbPair>* pairs : {&legs_, &others_}) {
            for (const LimbPair& pair : *pairs) {
                if (pairs == &others_ && pair.length() < LONG_WING * sizeOf(tree_)) continue;
                auto b = static_cast<int32_t>(pair.base);
                for (; b >= 0 && !tree_.isBelow(static_cast<int32_t>(pelvis_), b); b = tree_.parents[b]) trunk_[b] = 1;
                if (b < 0) continue;
                for (auto p = static_cast<int32_t>(pelvis_); p != b; p = tree_.parents[p]) trunk_[p] = trunk_[b] = 1;
            }
        }
        trunk_[pelvis_] = 0;
    }

    /// Single chains that leave the trunk: the highest is the head's, the others are tails.
    void readEnds()
    {
        std::vector<BoneChain> ends;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            if (b != pelvis_ && !trunk_[b]) continue;
            for (const uint32_t child : tree_.children[b])
                if (tree_.carries[child] && !inPair_[child] && !trunk_[child] && child != pelvis_)
                    ends.push_back(chainFrom(tree_, child));
        }
        const auto height = [&](const BoneChain& chain) { return tree_.heads[chain.bones[chain.fork]].y(); };
        const auto head = std::ranges::max_element(ends, {}, height);
        for (auto end = ends.begin(); end != ends.end(); ++end) {
            if (end == head && height(*end) > tree_.heads[pelvis_].y()) readHead(*end);
            else if (end->bones.size() >= 2)
                for (const uint32_t b : end->bones) call(b, BodyPart::Tail);
        }
    }

    /// Above the shoulders, the bone with much more skin than all further ones: these are a ponytail.
    size_t crownOf(const BoneChain& chain, size_t last) const
    {
        const int32_t base = tree_.parents[chain.bones.front()];
        float beyond = 0.0f;
        for (size_t i = last + 1; i-- > 0 && base >= 0 && trunk_[base];) {
            const float own = (tree_.tips[chain.bones[i]] - tree_.heads[chain.bones[i]]).norm();
            if (last - i >= PONYTAIL && own > 2 * beyond && beyond > 0.0f) return i;
            beyond = std::max(beyond, own);
        }
        return last;
    }

    void readHead(const BoneChain& chain)
    {
        // Ears and jaws hang on the head.
        size_t last = legs_.size() == 1 ? crownOf(chain, chain.fork) : chain.fork;
        for (const LimbPair& pair : others_)
            if (const auto at = std::ranges::find(chain.bones, pair.base); at != chain.bones.end())
                last = std::min(last, static_cast<size_t>(at - chain.bones.begin()));
        for (size_t i = 0; i <= last; ++i)
            call(chain.bones[i], i == last ? BodyPart::Head : i + MOST_NECKS < last ? BodyPart::Spine : BodyPart::Neck);
        head_ = static_cast<int32_t>(chain.bones[last]);
    }

    bool startsShort(const BoneChain& chain) const
    {
        const auto segment = [&](size_t i) {
            return (tree_.heads[chain.bones[i + 1]] - tree_.heads[chain.bones[i]]).norm();
        };
        return chain.bones.size() >= 3 && segment(0) < SHORT * segment(1);
    }

    /// The first joint near the ground; the number of bones for a leg without a foot.
    size_t footOf(const LimbPair& pair, const BoneChain& chain) const
    {
        const float root = tree_.heads[chain.bones.front()].y() - pair.lowest;
        size_t foot = 2;
        while (foot < chain.bones.size() && tree_.heads[chain.bones[foot]].y() - pair.lowest > FOOT * root) ++foot;
        return foot;
    }

    /// Where a limb's part begins, by names of any of its parts: number of bones from the chain's first; -1 if names do
    /// not say, or contradict each other.
    int placeOf(const BoneChain& chain, const std::vector<BodyPart>& parts, size_t part) const
    {
        int place = -1;
        for (size_t i = 0; i < chain.bones.size(); ++i) {
            const auto named = std::ranges::find(parts, named_[chain.bones[i]].part);
            if (named == parts.end()) continue;
            const auto at = static_cast<int>(i + part) - static_cast<int>(named - parts.begin());
            if (at < 0 || (place >= 0 && place != at)) return -1;
            place = at;
        }
        return place < static_cast<int>(chain.bones.size()) ? place : -1;
    }

    void readLeg(const LimbPair& pair, const BoneChain& chain, bool fore)
    {
        size_t first = chain.bones.size() >= 5 && startsShort(chain) ? 1 : 0, foot = first + 2;
        if (legs_.size() > 1) {
            foot = footOf(pair, chain);
            // A front leg has its shoulder blade; other legs begin with a short piece.
            const bool blade = fore && foot >= 3;
            first = foot >= 3 && (fore || startsShort(chain)) ? 1 : 0;
            if (first > 0) call(chain.bones[0], blade ? BodyPart::Clavicle : BodyPart::Coxa);
        } else if (const int place = placeOf(chain, {BodyPart::Thigh, BodyPart::Shin, BodyPart::Foot}, 0); place >= 0) {
            first = static_cast<size_t>(place);
            foot = first + 2;
        }
        for (size_t i = first; i < chain.bones.size(); ++i) {
            const BodyPart part = i == first ? BodyPart::Thigh
                                  : i < foot ? BodyPart::Shin
                                             : (i == foot ? BodyPart::Foot : BodyPart::Toe);
            call(chain.bones[i], fore ? ofForeLeg(part) : part);
        }
        if (foot < chain.bones.size()) callBelow(chain.bones[foot], BodyPart::Toe);
    }

    void readArm(const BoneChain& chain)
    {
        const size_t hand = chain.fork >= 2 ? chain.fork : chain.bones.size() - 1;
        size_t next = hand >= 3 ? 1 : 0;
        const int place = placeOf(chain, {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand}, 0);
        if (place >= 0) next = static_cast<size_t>(place);
        if (next > 0) call(chain.bones[next - 1], BodyPart::Clavicle);
        for (const BodyPart part : {BodyPart::UpperArm, BodyPart::Forearm, BodyPart::Hand})
            if (next < chain.bones.size()) call(chain.bones[next++], part);
        callBelow(chain.bones[next - 1], BodyPart::Finger);
    }

    /// Whether a leg is one of the two next to the head, of four.
    bool isForeLeg(const LimbPair& pair) const
    {
        if (legs_.size() != 2) return false;
        if (head_ < 0) return &pair == &legs_.back();
        const LimbPair& other = legs_[&pair == &legs_.front()];
        const auto away = [&](const LimbPair& p) {
            return (tree_.heads[p.chains[0].bones.front()] - tree_.heads[head_]).norm();
        };
        return away(pair) < away(other);
    }

    /// How much its length differs from that of arms.
    float unlikeArms(const LimbPair& pair) const
    {
        return pair.length() <= 0.0f ? INFINITY : std::abs(std::log(pair.length() / (ARM * legs_.front().length())));
    }

    void readPairs()
    {
        for (const LimbPair& pair : legs_)
            for (const BoneChain& chain : pair.chains) readLeg(pair, chain, isForeLeg(pair));
        const auto arms = std::ranges::min_element(others_, {}, [&](const LimbPair& p) { return unlikeArms(p); });
        for (auto pair = others_.begin(); pair != others_.end(); ++pair) {
            const bool onTrunk = trunk_[pair->base] || pair->base == pelvis_;
            if (!onTrunk || pair->length() < LONG_WING * sizeOf(tree_)) continue;
            for (const BoneChain& chain : pair->chains) {
                const bool asArms = pair == arms || (pair->count() == arms->count() &&
                                                     std::abs(unlikeArms(*pair) - unlikeArms(*arms)) < ALIKE);
                if (legs_.size() == 1 && asArms) readArm(chain);
                else
                    for (const uint32_t b : chain.bones) call(b, BodyPart::Wing);
            }
        }
    }

    /// The direction that it faces: from heels to toes; for a creature from its hips to its head.
    Vector3f forward() const
    {
        Vector3f way = Vector3f::Zero();
        const uint32_t front = head_ >= 0 ? static_cast<uint32_t>(head_) : legs_.back().base;
        if (legs_.size() > 1) way = tree_.heads[front] - tree_.heads[pelvis_];
        else
            for (const BoneChain& chain : legs_.front().chains)
                way += tree_.heads[chain.bones.back()] -
                       tree_.heads[chain.bones[std::min<size_t>(2, chain.bones.size() - 1)]];
        return way - way.dot(plane_.across) * plane_.across - way.y() * Vector3f::UnitY();
    }

    /// Whether the left is where the plane's distance is positive: by names, else by the direction that it faces.
    bool leftIsPositive() const
    {
        float said = 0.0f;
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (tree_.carries[b]) said += static_cast<float>(named_[b].side) * plane_.distance(tree_.heads[b]);
        if (said != 0.0f) return said > 0.0f;
        Vector3f ahead = forward();
        if (ahead.norm() < 0.01f * sizeOf(tree_)) ahead = Vector3f(0.1f, 0, 1);
        return Vector3f::UnitY().cross(ahead).dot(plane_.across) > 0;
    }

    void readSides()
    {
        const bool positive = leftIsPositive();
        for (const std::vector<LimbPair>* pairs : {&legs_, &others_})
            for (const LimbPair& pair : *pairs)
                for (size_t c = 0; c < 2; ++c)
                    for (uint32_t b = 0; b < tree_.size(); ++b)
                        if (anatomy_[b].side == 0 &&
                            tree_.isBelow(static_cast<int32_t>(b), pair.chains[c].bones.front()))
                            anatomy_[b].side = (c == 0) == positive ? 1 : -1;
    }

    const BoneTree& tree_;
    const MirrorPlane& plane_;
    const std::vector<BoneAnatomy>& named_;
    std::vector<BoneAnatomy>& anatomy_;
    std::vector<LimbPair> legs_, others_;
    std::vector<uint8_t> trunk_, inPair_;
    uint32_t pelvis_ = 0;
    int32_t head_ = -1;
};

}  // namespace

std::vector<BoneAnatomy> readShape(const BoneTree& tree, const std::vector<BoneAnatomy>& named)
{
    std::vector<BoneAnatomy> anatomy(tree.size());
    if (const std::optional<MirrorPlane> plane = findMirrorPlane(tree)) ShapeParts(tree, *plane, named, anatomy).read();
    return anatomy;
}

}  // namespace knuckle
