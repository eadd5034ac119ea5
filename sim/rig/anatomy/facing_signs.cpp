#include "sim/rig/anatomy/facing.h"

#include <algorithm>
#include <cmath>

#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/names/bone_name.h"
#include "sim/rig/anatomy/shape/mirror_plane.h"

namespace knuckle {

using Eigen::Matrix4f;
using Eigen::Vector3f;
using enum BodyPart;

namespace {

// Weights of signs.
constexpr float TOES = 1.5f, FACE = 1.5f, KNEES = 1.0f, ELBOWS = 0.75f, THUMBS = 0.75f, TAIL = 0.75f, TRUNK = 2.0f,
                CLIP_KNEES = 1.5f, STEPS = 1.0f;
constexpr float TOLD = 0.5f;       // signs with a smaller weight are not named
constexpr float LONG_TOES = 0.3f;  // of a foot's length, by which its front has to be longer than its heel
constexpr float BEFORE = 0.03f;    // of the figure's size: how far a face has to be before the head
constexpr float BENT = 0.04f;      // of a limb's length: how far its middle has to be off the straight line
constexpr float AHEAD = 0.25f;     // of the figure's size: how far a creature's head has to be before its hips
constexpr float STEP = 0.5f;       // of a leg's length: how far steps have to go
constexpr const char* FACE_WORDS[] = {"eye",  "brow",  "eyebrow", "eyelid", "nose",  "nostril", "mouth", "lip",
                                      "chin", "cheek", "tongue",  "tooth",  "teeth", "beak",    "jaw",   "whisker"};

class Signs {
public:
    Signs(const Model& model, std::span<const BoneAnatomy> anatomy)
        : model_(model), anatomy_(anatomy), tree_(model), size_(sizeOf(tree_)),
          forward_(leftOf(model, anatomy).cross(Vector3f::UnitY()))
    {
    }

    Facing count()
    {
        if (!(size_ > 0.0f) || !hasBothSides()) return {};
        upright_ = isUpright(model_, anatomy_);
        add("toes", TOES, toes());
        add("face", FACE, face());
        if (upright_) {
            add("knees", KNEES, bends(Thigh, Shin));
            add("elbows", ELBOWS, -bends(UpperArm, Forearm));
            add("thumbs", THUMBS, thumbs());
            add("knees in clips", CLIP_KNEES, kneesInClips());
        } else {
            add("head", TRUNK, (meanOf(Head) - meanOf(Hips)).dot(forward_) / (AHEAD * size_));
        }
        if (const Vector3f tail = meanOf(Tail); tail.allFinite())
            add("tail", TAIL, (meanOf(Hips) - tail).dot(forward_) / (BEFORE * size_));
        add("steps in clips", STEPS, steps());
        return facing_;
    }

private:
    bool isLimb(uint32_t b) const { return anatomy_[b].role == BoneRole::Limb; }

    bool hasBothSides() const
    {
        const auto has = [&](int side) {
            return std::ranges::any_of(anatomy_, [&](const BoneAnatomy& bone) {
                return bone.side == side && (bone.part == Thigh || bone.part == UpperArm);
            });
        };
        return has(1) && has(-1);
    }

    /// @param says 1 or more: surely the sides, -1 or less: surely the opposite; NaN: nothing.
    void add(const char* name, float weight, float says)
    {
        if (!std::isfinite(says)) return;
        const float counts = weight * std::clamp(says, -1.0f, 1.0f);
        facing_.balance += counts;
        if (std::abs(counts) < TOLD) return;
        facing_.against += std::max(-counts, 0.0f);
        (counts > 0 ? facing_.agree : facing_.disagree).emplace_back(name);
    }

    /// The mean of where limbs of a part begin; NaN if there are none.
    Vector3f meanOf(BodyPart part) const
    {
        Vector3f sum = Vector3f::Zero();
        float count = 0.0f;
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (isLimb(b) && anatomy_[b].part == part) sum += tree_.heads[b], count += 1.0f;
        return sum / count;
    }

    /// The limb of a part that a bone hangs on; -1 for none.
    int32_t above(uint32_t b, BodyPart part) const
    {
        int32_t limb = anatomy_[b].parent;
        while (limb >= 0 && anatomy_[limb].part != part && anatomy_[limb].side == anatomy_[b].side)
            limb = anatomy_[limb].parent;
        return limb >= 0 && anatomy_[limb].part == part ? limb : -1;
    }

    /// How much further feet, with toes, reach forward from the ankle than back.
    float toes() const
    {
        float sum = 0.0f, count = 0.0f;
        for (uint32_t foot = 0; foot < tree_.size(); ++foot) {
            if (!isLimb(foot) || anatomy_[foot].part != Foot) continue;
            float front = 0.0f, back = 0.0f;
            const auto reach = [&](const Vector3f& place) {
                const float way = (place - tree_.heads[foot]).dot(forward_);
                front = std::max(front, way);
                back = std::max(back, -way);
            };
            for (uint32_t b = 0; b < tree_.size(); ++b) {
                if (!tree_.isBelow(static_cast<int32_t>(b), foot)) continue;
                reach(tree_.heads[b]);
            }
            for (size_t v = 0; v < model_.skin.size(); ++v)
                if (tree_.isBelow(static_cast<int32_t>(heaviest(model_.skin[v])), foot)) reach(model_.vertices[v]);
            if (front + back < BEFORE * size_) continue;
            sum += (front - back) / (front + back) / LONG_TOES;
            count += 1.0f;
        }
        return sum / count;
    }

    static uint32_t heaviest(const SkinWeights& skin)
    {
        return skin.bones[static_cast<size_t>(std::ranges::max_element(skin.weights) - skin.weights.begin())];
    }

    float face() const
    {
        const Vector3f head = meanOf(Head);
        Vector3f sum = Vector3f::Zero();
        float count = 0.0f;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const std::vector<std::string> words = wordsOf(model_.bones[b].name);
            const auto isFaces = [](const std::string& word) {
                return std::ranges::any_of(FACE_WORDS, [&](const char* face) { return word == face; });
            };
            if (!std::ranges::any_of(words, isFaces)) continue;
            sum += tree_.heads[b];
            count += 1.0f;
        }
        return (sum / count - head).dot(forward_) / (BEFORE * size_);
    }

    /// How far the joint between two parts of limbs lies before the straight line from the first's head to where the
    /// second ends, relative to the least that shows a bend.
    float bends(BodyPart upper, BodyPart lower) const
    {
        float sum = 0.0f, count = 0.0f;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const int32_t top = isLimb(b) && anatomy_[b].part == lower ? above(b, upper) : -1;
            const int32_t end = top < 0 ? -1 : endOf(b);
            if (end < 0) continue;
            sum += offset(tree_.heads[top], tree_.heads[b], tree_.heads[end], forward_);
            count += 1.0f;
        }
        return sum / count / BENT;
    }

    int32_t endOf(uint32_t lower) const
    {
        const auto hangs = std::ranges::find_if(anatomy_, [&](const BoneAnatomy& bone) {
            return bone.parent == static_cast<int32_t>(lower) && (bone.part == Foot || bone.part == Hand);
        });
        return hangs == anatomy_.end() ? -1 : static_cast<int32_t>(hangs - anatomy_.begin());
    }

    static float offset(const Vector3f& top, const Vector3f& middle, const Vector3f& end, const Vector3f& forward)
    {
        const Vector3f way = end - top;
        const float length = (middle - top).norm() + (end - middle).norm();
        if (!(way.norm() > 0.0f)) return 0.0f;
        const Vector3f along = way.normalized(), off = middle - top - (middle - top).dot(along) * along;
        return off.dot(forward) / length;
    }

    float thumbs() const
    {
        float sum = 0.0f, count = 0.0f;
        for (const int side : {1, -1}) {
            Vector3f thumb = Vector3f::Zero(), others = Vector3f::Zero();
            float thumbCount = 0.0f, otherCount = 0.0f;
            for (uint32_t b = 0; b < tree_.size(); ++b) {
                if (anatomy_[b].part != Finger || anatomy_[b].side != side) continue;
                const std::vector<std::string> words = wordsOf(model_.bones[b].name);
                if (std::ranges::count(words, "thumb") > 0) thumb += tree_.heads[b], thumbCount += 1.0f;
                else others += tree_.heads[b], otherCount += 1.0f;
            }
            const Vector3f way = thumb / thumbCount - others / otherCount;
            if (!way.allFinite() || way.isZero()) continue;
            sum += way.dot(forward_) / way.norm() / 0.3f;
            count += 1.0f;
        }
        return sum / count;
    }

    /// The direction that the figure faces in a pose.
    Vector3f forwardIn(const std::vector<Matrix4f>& pose, uint32_t hips) const
    {
        const Eigen::Matrix3f turn =
            pose[hips].topLeftCorner<3, 3>().colwise().normalized() *
            model_.bones[hips].restPose.topLeftCorner<3, 3>().colwise().normalized().transpose();
        Vector3f forward = turn * forward_;
        forward.y() = 0.0f;
        return forward.norm() > 0.3f ? Vector3f(forward.normalized()) : Vector3f(Vector3f::Zero());
    }

    float kneesInClips() const
    {
        float sum = 0.0f, count = 0.0f;
        for (uint32_t b = 0; b < tree_.size(); ++b) {
            const int32_t top = isLimb(b) && anatomy_[b].part == Shin ? above(b, Thigh) : -1;
            const int32_t end = top < 0 ? -1 : endOf(b), hips = top < 0 ? -1 : anatomy_[top].parent;
            if (end < 0 || hips < 0) continue;
            for (const Clip& clip : model_.clips) {
                for (const std::vector<Matrix4f>& pose : clip.poses) {
                    sum += offset(headIn(pose[top]), headIn(pose[b]), headIn(pose[end]),
                                  forwardIn(pose, static_cast<uint32_t>(hips)));
                    count += 1.0f;
                }
            }
        }
        return sum / count / BENT;
    }

    /// How far clips go forward by their steps, in leg lengths: the standing foot goes back beneath the hips.
    float steps() const
    {
        std::vector<uint32_t> feet;
        for (uint32_t b = 0; b < tree_.size(); ++b)
            if (isLimb(b) && anatomy_[b].part == Foot) feet.push_back(b);
        const auto hips = std::ranges::find(anatomy_, Hips, &BoneAnatomy::part);
        if (feet.size() != 2 || hips == anatomy_.end() || model_.clips.empty()) return NAN;
        const auto root = static_cast<uint32_t>(hips - anatomy_.begin());
        const float leg = (tree_.heads[root] - tree_.heads[feet[0]]).norm();
        float way = 0.0f;
        for (const Clip& clip : model_.clips) {
            for (size_t k = 1; k < clip.poses.size(); ++k) {
                const auto &before = clip.poses[k - 1], &now = clip.poses[k];
                const auto height = [&](uint32_t foot) { return headIn(now[foot]).y(); };
                const uint32_t stands = height(feet[0]) < height(feet[1]) ? feet[0] : feet[1];
                const Vector3f moved = headIn(now[stands]) - headIn(before[stands]) - headIn(now[root]) +
                                       headIn(before[root]);
                way -= moved.dot(forwardIn(now, root));
            }
        }
        return way / (STEP * leg);
    }

    const Model& model_;
    std::span<const BoneAnatomy> anatomy_;
    BoneTree tree_;
    float size_;
    Vector3f forward_;
    bool upright_ = true;
    Facing facing_;
};

}  // namespace

Facing readFacing(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    return Signs(model, anatomy).count();
}

}  // namespace knuckle
