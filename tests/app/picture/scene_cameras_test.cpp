#include <gtest/gtest.h>

#include "app/scene/picture/late_parts.h"
#include "app/scene/picture/name_pattern.h"
#include "tests/app/one_object_scene.h"

namespace knuckle::test {
namespace {

constexpr const char* OBJECTS =
    R"({ "type": "rigid", "shape": "box", "name": "doll" },
       { "type": "rigid", "shape": "box", "name": "crate", "position": [3, 0, 0], "repeat": { "counts": [3, 1, 1] } })";

RenderSettings pictureOf(const std::string& fields)
{
    const TempFolder folder;
    return loadScene(folder.write("scene.json", "{" + fields + R"(, "diameter": 0.25, "objects": [)" + OBJECTS + "]}"),
                     {})
        .render;
}

std::string complaint(const std::string& fields)
{
    return complaintOf(OBJECTS, fields + ", ");
}

TEST(Cameras, AreChosenByTheirNamesInShots)
{
    const RenderSettings picture = pictureOf(
        R"("camera": { "fieldOfView": 50 }, "cameras": { "close": { "fieldOfView": 20, "roll": 5 } },
           "shots": [{ "from": 0 }, { "from": 2.4, "camera": "close", "timeScale": 0.25 }])");
    ASSERT_EQ(picture.shots.size(), 2u);
    EXPECT_EQ(picture.shots[0].camera.fieldOfView, 50.0f);
    EXPECT_EQ(picture.shots[0].timeScale, 1.0f);
    EXPECT_EQ(picture.shots[1].camera.fieldOfView, 20.0f);
    EXPECT_EQ(picture.shots[1].camera.roll, 5.0f);
    EXPECT_EQ(picture.shots[1].from, 2.4);
    EXPECT_EQ(picture.shots[1].timeScale, 0.25f);
}

TEST(Cameras, TwoOfThemShareThePicturesOfAShot)
{
    const std::string shots = R"("cameras": { "close": { "fieldOfView": 20 } },
           "shots": [{ "from": 0 }, { "from": 1, "beside": "close" }, { "from": 2, "inset": "close" },
                     { "from": 3, "inset": "close", "insetAt": "topLeft" }])";
    const RenderSettings picture = pictureOf(shots);
    ASSERT_EQ(picture.shots.size(), 4u);
    EXPECT_EQ(picture.shots[0].layout, PictureLayout::One);
    EXPECT_EQ(picture.shots[1].layout, PictureLayout::Beside);
    EXPECT_EQ(picture.shots[2].layout, PictureLayout::Inset);
    EXPECT_EQ(picture.shots[2].insetAt, Corner::BottomRight);
    EXPECT_EQ(picture.shots[3].insetAt, Corner::TopLeft);
    for (size_t k = 1; k < 4; ++k) {
        EXPECT_EQ(picture.shots[k].camera.fieldOfView, 40.0f);
        EXPECT_EQ(picture.shots[k].other.fieldOfView, 20.0f);
    }
    for (const Shot& shot : pictureOf(shots + R"(, "render": { "camera": "auto" })").shots)
        EXPECT_EQ(shot.layout, PictureLayout::One);
}

TEST(Cameras, AreOfTheKindThatTheirFieldsAreOf)
{
    const auto cameraOf = [](const std::string& field) { return pictureOf(R"("camera": { )" + field + " }").camera; };
    EXPECT_EQ(cameraOf(R"("follow": "doll")").kind, CameraKind::Follow);
    EXPECT_EQ(cameraOf(R"("follow": "doll")").target, Vector3f(0, 0, 0));
    EXPECT_TRUE(cameraOf(R"("follow": "doll")").automatic);
    EXPECT_EQ(cameraOf(R"("orbitSpeed": 5)").kind, CameraKind::Orbit);
    EXPECT_EQ(cameraOf(R"("fieldOfView": 30)").kind, CameraKind::Fixed);
}

TEST(Cameras, OfTheCommandLineFilmEveryShot)
{
    const std::string shots = R"("duration": 8, "cameras": { "close": { "fieldOfView": 20 } },
                                 "shots": [{ "from": 0 }, { "from": 1, "timeScale": 0.5 }], "render": { "camera": )";
    const RenderSettings close = pictureOf(shots + R"("close" })");
    for (const Shot& shot : close.shots) EXPECT_EQ(shot.camera.fieldOfView, 20.0f);
    EXPECT_EQ(close.shots[1].timeScale, 0.5f);
    EXPECT_TRUE(pictureOf(shots + R"("auto" })").shots[1].camera.automatic);
    const CameraSettings around = pictureOf(shots + R"("turntable" })").shots[1].camera;
    EXPECT_EQ(around.kind, CameraKind::Orbit);
    EXPECT_EQ(around.orbitSpeed, 45.0f);
}

TEST(Cameras, KeysGoOnFromTheOnesBefore)
{
    const std::vector<CameraKey> keys = pictureOf(R"("camera": { "position": [1, 2, 3], "fieldOfView": 30, "keys": [
            { "time": 1, "target": [0, 0, 1] }, { "time": 2, "fieldOfView": 60 },
            { "time": 3, "position": [4, 2, 3], "easing": "easeIn", "roll": -9 }] })")
                                            .camera.keys;
    ASSERT_EQ(keys.size(), 3u);
    EXPECT_EQ(keys[0].position, Vector3f(1, 2, 3));
    EXPECT_EQ(keys[1].target, Vector3f(0, 0, 1));
    EXPECT_EQ(keys[0].fieldOfView, 30.0f);
    EXPECT_EQ(keys[2].fieldOfView, 60.0f);
    EXPECT_EQ(keys[2].roll, -9.0f);
    EXPECT_EQ(keys[1].easing, Easing::Smooth);
    EXPECT_EQ(keys[2].easing, Easing::EaseIn);
}

TEST(Cameras, FrameObjectsAndCopiesByName)
{
    const auto named = [](const std::string& words) {
        uint32_t count = 0;
        for (const ParticleRange& range : pictureOf(R"("camera": { "frame": [)" + words + "] }").camera.named)
            count += range.end - range.first;
        return count;
    };
    const uint32_t one = named(R"("doll")");
    EXPECT_GT(one, 0u);
    EXPECT_EQ(named(R"("crate_2")"), one);
    EXPECT_EQ(named(R"("crate")"), 3 * one);
    EXPECT_EQ(named(R"("crate_*")"), 3 * one);
    EXPECT_EQ(named(R"("doll", "*_1")"), 2 * one);
}

TEST(Cameras, FrameUnlessTheyOnlyLook)
{
    const CameraSettings frames = pictureOf(R"("camera": { "frame": ["doll"] })").camera;
    EXPECT_EQ(frames.attention, CameraAttention::Frame);
    EXPECT_EQ(frames.fill, 0.7f);
    EXPECT_TRUE(frames.automatic);
    const CameraSettings looks = pictureOf(R"("camera": { "lookAt": ["doll"] })").camera;
    EXPECT_EQ(looks.attention, CameraAttention::LookAt);
    EXPECT_FALSE(looks.automatic);
}

TEST(Cameras, OfEverySceneAreThoseOfShots)
{
    const RenderSettings picture = pictureOf(
        R"("duration": 4, "camera": { "position": [1, 2, 3] }, "shots": [{ "from": 0, "camera": "auto" },
                     { "from": 1, "camera": "turntable", "inset": "auto" }])");
    ASSERT_EQ(picture.shots.size(), 2u);
    EXPECT_TRUE(picture.shots[0].camera.automatic);
    EXPECT_EQ(picture.shots[1].camera.kind, CameraKind::Orbit);
    EXPECT_EQ(picture.shots[1].camera.orbitSpeed, 90.0f);
    EXPECT_TRUE(picture.shots[1].other.automatic);
}

/// A longer film goes on from the states of a shorter one, unless they show something else.
TEST(Cameras, ThatTurnDependOnTheFilmsLength)
{
    const auto hashOf = [](const std::string& shots, double duration) {
        const TempFolder folder;
        return loadScene(
                   folder.write("scene.json", "{" + shots + R"("objects": [{ "type": "rigid", "shape": "box" }]})"),
                   {{"duration", duration}})
            .documentHash;
    };
    for (const std::string field : {"camera", "inset", "beside"}) {
        const std::string shots = R"("shots": [{ "from": 0, ")" + field + R"(": "NAME" }], )";
        const auto with = [&](const std::string& name) {
            return std::string(shots).replace(shots.find("NAME"), 4, name);
        };
        EXPECT_NE(hashOf(with("turntable"), 2.0), hashOf(with("turntable"), 3.0)) << field;
        EXPECT_EQ(hashOf(with("auto"), 2.0), hashOf(with("auto"), 3.0)) << field;
    }
}

TEST(Cameras, OfShotsThatNobodySeesAreTold)
{
    RenderSettings picture;
    picture.shots = {{.from = 0.0}, {.from = 2.0}, {.from = 3.5}};
    picture.overlay.captions = {{.text = "seen", .from = 1.9f}, {.text = "late", .from = 2.5f}};
    EXPECT_EQ(lateParts(picture, 2.0),
              (std::vector<std::string>{"/shots/1/from is 2 s, when the film of 2 s is over: it is not seen.",
                                        "/shots/2/from is 3.5 s, when the film of 2 s is over: it is not seen.",
                                        "/captions/1/from is 2.5 s, when the film of 2 s is over: it is not seen."}));
    EXPECT_TRUE(lateParts(picture, 4.0).empty());
}

TEST(Cameras, AreRefusedInOneLine)
{
    const std::pair<const char*, const char*> wrong[] = {
        {R"("shots": [{ "from": 0, "camera": "wide" }])",
         "/shots/0/camera: there is no camera \"wide\"; add it to `cameras`"},
        {R"("cameras": { "close": {}, "wide": {} }, "shots": [{ "from": 0, "camera": "cloze" }])",
         "/shots/0/camera: there is no camera \"cloze\"; did you mean \"close\"?"},
        {R"("render": { "camera": "x" }, "cameras": { "close": {}, "wide": {} })",
         "/render/camera: there is no camera \"x\"; known: auto, close, turntable, wide"},
        {R"("cameras": { "close": {} }, "shots": [{ "from": 0, "beside": "closer" }])",
         "/shots/0/beside: there is no camera \"closer\"; did you mean \"close\"?"},
        {R"("cameras": { "close": {} }, "shots": [{ "from": 0, "beside": "close", "inset": "close" }])",
         "/shots/0/beside: is given beside `inset`; take one of them away"},
        {R"("cameras": { "a=b": {} })", "/cameras/a=b: \"a=b\" is no name for a camera; choose another one"},
        {R"("cameras": { "auto": {} })", "/cameras/auto: \"auto\" is no name for a camera; choose another one"},
        {R"("shots": [{ "from": 1 }])", "/shots/0/from: must be 0: the film begins with it"},
        {R"("shots": [{ "from": 0 }, { "from": 2 }, { "from": 2 }])",
         "/shots/2/from: must be after that of the shot before"},
        {R"("shots": [{ "camera": "" }])",
         "/shots/0: \"from\" is missing; add it: When it begins, in the time of the film: `timeScale` changes how "
         "much is simulated, not `duration`. The first begins at 0. Its first frame is the first at this time or "
         "later."},
        {R"("shots": [{ "from": 0, "timeScale": -1 }])", "/shots/0/timeScale: -1 is below the minimum 0"},
        {R"("shots": [{ "from": 0, "timeScale": 2000 }])", "/shots/0/timeScale: 2000 is above the maximum 1000"},
        {R"("camera": { "keys": [{ "time": 2 }, { "time": 1 }] })",
         "/camera/keys/1/time: must be after that of the key before"},
        {R"("camera": { "keys": [{ "time": 0, "easing": "smoth" }] })",
         "/camera/keys/0/easing: \"smoth\" is unknown; did you mean \"smooth\"?"},
        {R"("camera": { "keys": [{ "time": 0, "position": [0, 1, 0] }] })",
         "/camera/keys/0: has the camera where it looks; move `position` or `target`"},
        {R"("camera": { "kind": "orbit", "keys": [{ "time": 0 }] })",
         "/camera/keys: are for a camera of kind \"fixed\"; take one of them away"},
        {R"("cameras": { "close": { "frame": ["crate", "dol"] } })",
         "/cameras/close/frame/1: there is no object \"dol\"; did you mean \"doll\"?"},
        {R"("camera": { "frame": ["doll"], "lookAt": ["doll"] })",
         "/camera/lookAt: is given beside `frame`, which turns the camera as well; take one of them away"},
        {R"("camera": { "kind": "follow", "lookAt": ["doll"] })",
         "/camera/lookAt: is given beside the kind \"follow\", which looks at its object; take one of them away"},
        {R"("camera": { "kind": "orbit", "follow": "doll" })",
         "/camera/follow: is given beside a `kind` that follows nothing; take one of them away"},
        {R"("camera": { "lookAt": ["doll"], "automatic": true })",
         "/camera/automatic: must be false with `lookAt`: give a position, or `frame` instead"},
        {R"("camera": { "shake": { "amplitude": 90 } })",
         "/camera/shake/amplitude: 90 is above the maximum 20 [degrees]"},
    };
    for (const auto& [fields, message] : wrong) EXPECT_EQ(complaint(fields), message) << fields;
}

TEST(NamePattern, TakesAnyLettersForAStar)
{
    EXPECT_TRUE(fits("crate_12", "crate_12"));
    EXPECT_TRUE(fits("crate_12", "crate*"));
    EXPECT_TRUE(fits("crate", "crate*"));
    EXPECT_TRUE(fits("crate_12", "*_1*"));
    EXPECT_TRUE(fits("aab", "*ab"));
    EXPECT_FALSE(fits("crate", "crat"));
    EXPECT_FALSE(fits("crate", "rate*"));
    EXPECT_FALSE(fits("crate", "*x*"));
}

}  // namespace
}  // namespace knuckle::test
