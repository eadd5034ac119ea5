#include "sim/rig/anatomy/limb_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace knuckle {

namespace {

using enum BodyPart;

constexpr float AT_END = 0.5f;      // of a limb's length: bones as near as this are at its end
constexpr float OTHER_KIND = 2.0f;  // a foot is this much farther from an arm than from a leg
constexpr int CONTRADICTION = 2;    // "front" against "back" counts as this many words that agree
constexpr std::array PLACES{"front", "back", "middle"};

bool isPlace(const std::string& word)
{
    return std::ranges::count(PLACES, word) > 0;
}

bool has(const std::vector<std::string>& words, const std::string& word)
{
    return std::ranges::count(words, word) > 0;
}

class EndFinder {
public:
    EndFinder(const BoneTree& tree, const std::vector<BoneName>& names, const std::vector<BoneAnatomy>& anatomy,
              std::span<const uint8_t> hasBody, uint32_t end, BodyPart part)
        : tree_(tree), names_(names), anatomy_(anatomy), hasBody_(hasBody), end_(end), part_(part)
    {
    }

    int32_t find() const
    {
        int32_t best = -1;
        std::tuple<int, bool, float> least{};
        for (uint32_t limb = 0; limb < tree_.size(); ++limb) {
            if (!fits(limb)) continue;
            const float length = (tree_.tips[limb] - tree_.heads[limb]).norm();
            const float away = distance(limb);
            const int said = agreement(limb);
            const bool isNear = away <= AT_END * length;
            if ((!ofKind(limb) || part_ == Other) && !isNear && said <= 0) continue;
            const std::tuple order(-said, isTaken(limb), ofKind(limb) ? away : OTHER_KIND * away);
            if (best >= 0 && order >= least) continue;
            best = static_cast<int32_t>(limb);
            least = order;
        }
        return best;
    }

private:
    /// Parts that the end may hang on. Fingers, toes and halves of limbs have only one.
    bool isWanted(BodyPart other, uint32_t limb) const
    {
        switch (part_) {
            case Finger: return other == Hand;
            case Toe: return other == Foot || other == Hand;
            case Shin: return other == Thigh || other == UpperArm;
            case Forearm: return other == UpperArm;
            case Hand: return other == Forearm || (other == UpperArm && isLast(limb));
            default:
                return other == Shin || other == Forearm || ((other == Thigh || other == UpperArm) && isLast(limb));
        }
    }

    bool ofKind(uint32_t limb) const
    {
        const BodyPart on = anatomy_[limb].part;
        const bool onArm = on == UpperArm || on == Forearm || on == Hand;
        return part_ == Other || onArm == (part_ == Hand || part_ == Finger || part_ == Forearm);
    }

    bool fits(uint32_t limb) const
    {
        const BoneAnatomy& bone = anatomy_[limb];
        if (limb == end_ || bone.role != BoneRole::Limb || !hasBody_[limb] || bone.side != anatomy_[end_].side)
            return false;
        // Of a shin of several bones, the lowest has the foot.
        const bool lower = bone.part == Shin || bone.part == Forearm;
        return isWanted(bone.part, limb) && (!lower || isLast(limb)) && !hangsOn(limb);
    }

    /// Whether no further piece of a limb hangs on it.
    bool isLast(uint32_t limb) const
    {
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart next = anatomy_[b].part;
            const bool goesOn = next == Shin || next == Forearm;
            if (b != end_ && goesOn && anatomy_[b].parent == static_cast<int32_t>(limb)) return false;
        }
        return true;
    }

    /// Whether the limb already has another bone of the same kind.
    bool isTaken(uint32_t limb) const
    {
        if (part_ == Finger || part_ == Toe) return false;
        const bool half = part_ == Shin || part_ == Forearm;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const BodyPart other = anatomy_[b].part;
            const bool same = half ? other == Shin || other == Forearm : other == Foot || other == Hand;
            if (b != end_ && same && anatomy_[b].parent == static_cast<int32_t>(limb)) return true;
        }
        return false;
    }

    bool hangsOn(uint32_t limb) const
    {
        auto bone = static_cast<int32_t>(limb);
        while (bone >= 0 && bone != static_cast<int32_t>(end_)) bone = anatomy_[bone].parent;
        return bone >= 0;
    }

    /// Words in the names of a limb other than its part and side. If none names a place, arms are in front.
    std::vector<std::string> wordsOf(uint32_t limb) const
    {
        std::vector<std::string> words;
        const int side = anatomy_[limb].side;
        for (auto b = static_cast<int32_t>(limb); b >= 0 && anatomy_[b].side == side; b = anatomy_[b].parent)
            for (const std::string& word : names_[b].others) words.push_back(word);
        const BodyPart on = anatomy_[limb].part;
        const bool arm = on == UpperArm || on == Forearm || on == Hand;
        if (std::ranges::none_of(words, isPlace)) words.emplace_back(arm ? "front" : "back");
        return words;
    }

    int agreement(uint32_t limb) const
    {
        const std::vector<std::string> words = wordsOf(limb);
        int count = 0;
        for (const std::string& word : names_[end_].others) {
            if (has(words, word)) ++count;
            else if (isPlace(word)) count -= CONTRADICTION;
        }
        return count;
    }

    /// Distance of the end's head from the limb, which runs from its head as far as its skin does [m].
    float distance(uint32_t limb) const
    {
        const Eigen::Vector3f way = tree_.tips[limb] - tree_.heads[limb], from = tree_.heads[end_] - tree_.heads[limb];
        const float share = way.isZero() ? 0.0f : std::clamp(from.dot(way) / way.squaredNorm(), 0.0f, 1.0f);
        return (from - share * way).norm();
    }

    const BoneTree& tree_;
    const std::vector<BoneName>& names_;
    const std::vector<BoneAnatomy>& anatomy_;
    std::span<const uint8_t> hasBody_;
    uint32_t end_;
    BodyPart part_;
};

}  // namespace

int32_t limbOfEnd(const BoneTree& tree, const std::vector<BoneName>& names, const std::vector<BoneAnatomy>& anatomy,
                  std::span<const uint8_t> hasBody, uint32_t end, BodyPart part)
{
    return EndFinder(tree, names, anatomy, hasBody, end, part).find();
}

}  // namespace knuckle
