#include "sim/rig/bodies/merge_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "sim/base/short_list.h"

namespace knuckle {

namespace {

constexpr size_t ROW = 3;  // from so many bones of one part on, they are counted, not named

constexpr std::array<std::pair<BodyPart, const char*>, 4> ROWS{
    {{BodyPart::Finger, "fingers"}, {BodyPart::Toe, "toes"}, {BodyPart::Tail, "tails"}, {BodyPart::Wing, "wings"}}};

const char* whyMerged(const BoneAnatomy& bone, bool isWanted, bool isPlanned)
{
    if (bone.role == BoneRole::Twist) return "of the same limb";
    if (bone.role != BoneRole::Attached && isPlanned) return "too small at the coarsest level";
    if (bone.role != BoneRole::Attached) return "too small for four particles that span space";
    return isWanted ? "as --merge says" : "attached to it";
}

/// "15 bones of fingers", "a, b"
std::string listed(const Figure& figure, std::vector<uint32_t> bones)
{
    std::vector<std::string> texts, names;
    for (const auto& row : ROWS) {
        const auto isInRow = [&](uint32_t bone) { return figure.anatomy[bone].part == row.first; };
        const auto count = static_cast<size_t>(std::ranges::count_if(bones, isInRow));
        if (count < ROW) continue;
        texts.push_back(fmt::format("{} bones of {}", count, row.second));
        std::erase_if(bones, isInRow);
    }
    std::ranges::sort(bones);
    for (const uint32_t bone : bones) names.push_back(figure.model.bones[bone].name);
    if (!names.empty()) texts.push_back(shortList(names));
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

void noteMerged(const Figure& figure, const std::vector<BodyDraft>& drafts, bool isPlanned,
                std::vector<std::string>& notes)
{
    for (const BodyDraft& draft : drafts) {
        std::vector<std::pair<std::string, std::vector<uint32_t>>> groups;
        for (const uint32_t bone : draft.mergedBones) {
            const std::string why = whyMerged(figure.anatomy[bone], figure.wanted.contains(bone), isPlanned);
            auto group = std::ranges::find(groups, why, &std::pair<std::string, std::vector<uint32_t>>::first);
            if (group == groups.end()) group = groups.insert(group, {why, {}});
            group->second.push_back(bone);
        }
        for (const auto& [why, bones] : groups)
            notes.push_back(fmt::format("{} took in {}, {}.", draft.name, listed(figure, bones), why));
    }
}

}  // namespace knuckle
