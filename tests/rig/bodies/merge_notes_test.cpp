#include "sim/rig/bodies/merge_notes.h"

#include <gtest/gtest.h>

#include "sim/base/short_list.h"

namespace knuckle {
namespace {

TEST(ShortList, NamesTheFirstAndCountsTheOthers)
{
    const std::vector<std::string> names{"a", "b", "c", "d", "e"};
    EXPECT_EQ(shortList(std::span(names).first(1)), "a");
    EXPECT_EQ(shortList(std::span(names).first(4)), "a, b, c, d");
    EXPECT_EQ(shortList(names), "a, b, c and 2 more");
    EXPECT_EQ(shortList(names, 2), "a and 4 more");
}

TEST(MergeNotes, CountFingersAndNameTheFirstOfOthers)
{
    Model model;
    std::vector<BoneAnatomy> anatomy;
    BodyDraft hand{"hand", 0, -1, {}, {}};
    const auto add = [&](const std::string& name, BodyPart part, BoneRole role) {
        if (!model.bones.empty()) hand.mergedBones.push_back(static_cast<uint32_t>(model.bones.size()));
        model.bones.push_back({name, -1});
        anatomy.push_back({.part = part, .role = role});
    };
    add("hand", BodyPart::Hand, BoneRole::Limb);
    for (const char* palm : {"palm1", "palm2"}) add(palm, BodyPart::Hand, BoneRole::Twist);
    for (int i = 0; i < 15; ++i) add("finger" + std::to_string(i), BodyPart::Finger, BoneRole::Limb);
    add("nub", BodyPart::Other, BoneRole::Limb);
    for (const char* prop : {"ring", "watch", "glove", "sleeve", "button"})
        add(prop, BodyPart::Other, BoneRole::Attached);
    add("cane", BodyPart::Other, BoneRole::Attached);
    std::vector<std::string> notes;
    Figure figure = readFigure(model, {{24, BoneRole::Attached}});
    figure.anatomy = anatomy;
    noteMerged(figure, {hand}, false, notes);
    EXPECT_EQ(notes, (std::vector<std::string>{
                         "hand took in palm1, palm2, of the same limb.",
                         "hand took in 15 bones of fingers, nub, too small for four particles that span space.",
                         "hand took in ring, watch, glove and 2 more, attached to it.",
                         "hand took in cane, as --merge says."}));
    notes.clear();
    noteMerged(figure, {hand}, true, notes);
    EXPECT_EQ(notes.at(1), "hand took in 15 bones of fingers, nub, too small at the coarsest level.");
}

}  // namespace
}  // namespace knuckle
