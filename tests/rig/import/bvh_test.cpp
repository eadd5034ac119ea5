#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "sim/rig/import/bvh/bvh_text.h"
#include "sim/rig/import/import.h"
#include "tests/message_of.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

/// The style in which a BVH figure is written.
struct Written {
    const char* name = "Hips";
    float unit = 100.0f;        ///< Per metre.
    const char* up = "y";       ///< The axis that points up: y, z, -z, x.
    const char* left = "Left";  ///< "Left " for names of two words.
    bool isSmall = false;       ///< Channels in small letters.
    Vector3f lies{0, 0, 0};     ///< Angles of the root about z, x, y in all frames [degrees].
};

class Writer {
public:
    explicit Writer(const Written& how) : how_(how) {}

    std::string hierarchy()
    {
        const auto joint = [&](const std::string& name, const Vector3f& place, const std::string& inside) {
            ++joints_;
            return fmt::format("JOINT {}\n{{\n{}CHANNELS 3 {}\n{}}}\n", name, offset(place), channels("rotation"),
                               inside);
        };
        const auto end = [&](const Vector3f& place) { return fmt::format("End Site\n{{\n{}}}\n", offset(place)); };
        const auto limbs = [&](const std::string& side, float x) {
            return joint(side + "UpLeg", {0.09f * x, -0.04f, 0},
                         joint(side + "Leg", {0, -0.42f, 0},
                               joint(side + "Foot", {0, -0.4f, 0}, end({0, -0.05f, 0.14f})))) +
                   joint(side + "Arm", {0.17f * x, 0.5f, 0},
                         joint(side + "Hand", {0.5f * x, 0, 0}, end({0.15f * x, 0, 0})));
        };
        const std::string body = joint("Spine", {0, 0.3f, 0}, joint("Head", {0, 0.3f, 0}, end({0, 0.2f, 0}))) +
                                 limbs(how_.left, 1) + limbs("Right", -1);
        return fmt::format("ROOT {}\n{{\n{}CHANNELS 6 {} {}\n{}}}\n", how_.name, offset({0, 0, 0}),
                           channels("position"), channels("rotation"), body);
    }
    /// The values of one frame.
    std::string values() const
    {
        const Vector3f at = turned({0, 0.93f, 0});
        std::string text = fmt::format("{} {} {} {} {} {}", at.z(), at.x(), at.y(), how_.lies.x(), how_.lies.y(),
                                       how_.lies.z());
        for (int k = 0; k < joints_; ++k) text += " 5 0 0";
        return text;
    }

private:
    Vector3f turned(const Vector3f& p) const
    {
        const std::string up = how_.up;
        const Vector3f to = up == "y"    ? p
                            : up == "z"  ? Vector3f(p.x(), -p.z(), p.y())
                            : up == "-z" ? Vector3f(p.x(), p.z(), -p.y())
                                         : Vector3f(p.y(), -p.x(), p.z());
        return how_.unit * to;
    }
    std::string offset(const Vector3f& place) const
    {
        const Vector3f p = turned(place);
        return fmt::format("OFFSET {} {} {}\n", p.x(), p.y(), p.z());
    }
    std::string channels(const char* what) const
    {
        return how_.isSmall ? fmt::format("z{0} x{0} y{0}", what) : fmt::format("Z{0} X{0} Y{0}", what);
    }

    Written how_;
    int joints_ = 0;
};

std::string bvh(const std::vector<Written>& figures)
{
    std::string text = "HIERARCHY\n", frame;
    for (const Written& figure : figures) {
        Writer writer(figure);
        text += writer.hierarchy();
        frame += (frame.empty() ? "" : " ") + writer.values();
    }
    return text + "MOTION\nFrames: 2\nFrame Time: 0.05\n" + frame + "\n" + frame + "\n";
}

Model import(const std::string& text, const ImportOptions& options = {})
{
    const test::TempFolder folder;
    return importModel(folder.write("figure.bvh", text), options);
}

Vector3f sizeOf(const Model& model)
{
    Eigen::AlignedBox3f box;
    for (const Vector3f& vertex : model.vertices) box.extend(vertex);
    return box.sizes();
}

bool isTold(const Model& model, const std::string& words)
{
    return std::ranges::any_of(model.notes,
                               [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

// Checks that it is 1.71 m from the soles to the crown, including the flesh around the bones.
void expectStanding(const Model& model, const std::string& what)
{
    EXPECT_NEAR(sizeOf(model).y(), 1.8f, 0.12f) << what;
    EXPECT_LT(sizeOf(model).z(), 0.6f) << what;
}

TEST(Bvh, FiguresStandWhicheverAxisIsUp)
{
    const Model plain = import(bvh({{}}));
    expectStanding(plain, "y");
    EXPECT_FALSE(isTold(plain, "taken for up"));
    for (const char* up : {"z", "-z", "x"}) {
        const Model model = import(bvh({{.up = up}}));
        expectStanding(model, up);
        EXPECT_TRUE(isTold(model, fmt::format("The figure stands along {}: that was taken for up.", up)));
        EXPECT_FALSE(isTold(model, "none that a body has")) << up;
        // In its clip as well as at rest.
        const auto head = std::ranges::find(model.bones, "Head", &Bone::name) - model.bones.begin();
        const auto foot = std::ranges::find(model.bones, "LeftFoot", &Bone::name) - model.bones.begin();
        const auto& pose = model.clips.at(0).poses[0];
        EXPECT_GT(pose[static_cast<size_t>(head)](1, 3) - pose[static_cast<size_t>(foot)](1, 3), 1.2f) << up;
    }
}

TEST(Bvh, AFigureThatLiesInItsClipLies)
{
    // Turned by 90 degrees about x: lies along z, while its rest pose stands along y.
    const Model model = import(bvh({{.lies = {0, 90, 0}}}));
    expectStanding(model, "rest");
    EXPECT_FALSE(isTold(model, "taken for up"));
}

TEST(Bvh, UnitsAreThoseThatMakeAPerson)
{
    for (const auto& [name, unit] : {std::pair("centimetres", 100.0f),
                                     {"millimetres", 1000.0f},
                                     {"decimetres", 10.0f},
                                     {"inches", 1 / 0.0254f},
                                     {"feet", 1 / 0.3048f},
                                     {"units of 56.4 mm", 0.45f / 0.0254f}}) {
        const Model model = import(bvh({{.unit = unit}}));
        expectStanding(model, name);
        EXPECT_TRUE(isTold(model, fmt::format("taken for {}", name))) << name;
        expectStanding(import(bvh({{.unit = unit, .up = "z"}})), name);
    }
    expectStanding(import(bvh({{.unit = 1.0f}})), "metres");
}

TEST(Bvh, WordsInSmallLettersAndNamesOfTwoWordsAreRead)
{
    const Model plain = import(bvh({{}}));
    const Model model = import(bvh({{.left = "Left ", .isSmall = true}}));
    ASSERT_EQ(model.bones.size(), plain.bones.size());
    EXPECT_NE(std::ranges::find(model.bones, "Left Foot", &Bone::name), model.bones.end());
    EXPECT_EQ(model.vertices.size(), plain.vertices.size());
    for (size_t b = 0; b < model.bones.size(); ++b)
        EXPECT_TRUE(model.clips.at(0).poses[1][b].isApprox(plain.clips.at(0).poses[1][b], 1e-5f))
            << model.bones[b].name;
    std::string shouted = bvh({{}});
    for (const auto& [from, to] : {std::pair("HIERARCHY", "Hierarchy"),
                                   {"JOINT", "Joint"},
                                   {"Zrotation", "ZROTATION"},
                                   {"MOTION", "Motion"},
                                   {"Frames:", "frames:"},
                                   {"Frame Time:", "FRAME TIME:"}})
        for (size_t at = shouted.find(from); at != std::string::npos; at = shouted.find(from, at + 1))
            shouted.replace(at, std::string(from).size(), to);
    EXPECT_EQ(import(shouted).bones.size(), plain.bones.size());
    // Names that become equal without their spaces stay distinct.
    const PreparedBvh two = prepareBvh(
        "HIERARCHY ROOT a_b { OFFSET 0 0 0 CHANNELS 0 JOINT a b { OFFSET 0 1 0 CHANNELS 0 "
        "End Site { OFFSET 0 1 0 } } } MOTION Frames: 0 Frame Time: 1",
        "");
    EXPECT_NE(two.text.find("JOINT a_b_\n"), std::string::npos) << two.text;
    EXPECT_EQ(two.originals.at("a_b_"), "a b");
}

TEST(Bvh, OfSeveralRootsOneIsTaken)
{
    const std::string text = bvh({{.name = "A"}, {.name = "B", .lies = {0, 0, 40}}, {.name = "A"}});
    EXPECT_NE(test::messageOf<SkeletonError>([&] {
                  import(text);
              }).find("it holds 3 skeletons: A (13 bones), B (13 bones), A#2 (13 bones)"),
              std::string::npos);
    EXPECT_NE(test::messageOf<SkeletonError>([&] {
                  import(text, {.pick = {.skeleton = "C" }});
              }).find("it has no skeleton 'C', but A"),
              std::string::npos);
    const Model second = import(text, {.pick = {.skeleton = "B"}});
    const Model alone = import(bvh({{.name = "B", .lies = {0, 0, 40}}}));
    EXPECT_TRUE(isTold(second, "Of 3 skeletons only B was taken."));
    ASSERT_EQ(second.bones.size(), alone.bones.size());
    for (size_t b = 0; b < alone.bones.size(); ++b)
        EXPECT_EQ(second.clips.at(0).poses[1][b], alone.clips.at(0).poses[1][b]) << alone.bones[b].name;
    EXPECT_EQ(import(text, {.pick = {.skeleton = "A#2"}}).bones.size(), alone.bones.size());
}

TEST(Bvh, AllOfSeveralRootsAreOneWhereThatIsAskedFor)
{
    const std::string text = bvh({{.name = "A"}, {.name = "B", .lies = {0, 0, 40}}});
    const Model all = import(text, {.pick = {.skeleton = "*"}}), first = import(bvh({{.name = "A"}})),
                second = import(bvh({{.name = "B", .lies = {0, 0, 40}}}));
    ASSERT_EQ(all.bones.size(), 1 + first.bones.size() + second.bones.size());
    // Joints of one name each move by their own columns.
    for (const Model* one : {&first, &second}) {
        const size_t from = 1 + (one == &second ? first.bones.size() : 0);
        for (size_t b = 0; b < one->bones.size(); ++b) {
            EXPECT_TRUE(all.bones[from + b].name.starts_with(one->bones[b].name)) << all.bones[from + b].name;
            EXPECT_TRUE(all.clips.at(0).poses[1][from + b].isApprox(one->clips.at(0).poses[1][b], 1e-4f))
                << one->bones[b].name;
        }
    }
}

TEST(Bvh, WhatIsNoneIsLeftToTheReader)
{
    for (const std::string text :
         {"", "HIERARCHY", "HIERARCHY ROOT", "HIERARCHY ROOT a {", "HIERARCHY ROOT a { OFFSET 1 ",
          "HIERARCHY ROOT a { CHANNELS 99999999 x", "HIERARCHY ROOT a { JOINT { } }"})
        EXPECT_EQ(prepareBvh(text, "").text, text);
}

}  // namespace
}  // namespace knuckle
