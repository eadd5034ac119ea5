#include "app/schema/schema.h"

#include <gtest/gtest.h>

#include "app/json/fields.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

/// Compares as floats: the schema's 0.1, read as a double, is not the struct's float.
void expectSame(const std::string& field, const Json& inSchema, const Json& inStruct)
{
    if (inStruct.is_array()) {
        ASSERT_EQ(inSchema.size(), inStruct.size()) << field;
        for (size_t i = 0; i < inStruct.size(); ++i) expectSame(field, inSchema[i], inStruct[i]);
    } else if (inStruct.is_number_float()) {
        EXPECT_EQ(inSchema.get<float>(), inStruct.get<float>()) << field;
    } else {
        EXPECT_EQ(inSchema, inStruct) << field;
    }
}

/// Checks that every field of T is a property of the definition with the struct's default, and vice versa.
template <typename T>
void expectSameDefaults(const std::string& definition, const std::vector<std::string>& extra = {})
{
    const Schema schema("scene.schema.json");
    const Json &object = schema.root()["definitions"][definition], &properties = object["properties"];
    const Json required = object.value("required", Json::array());
    const Json fields = writeFields(T{});
    for (const auto& [key, value] : fields.items()) {
        ASSERT_TRUE(properties.contains(key)) << definition << "." << key;
        if (std::find(required.begin(), required.end(), key) != required.end()) continue;
        expectSame(definition + "." + key, schema.resolve(properties[key])["default"], value);
    }
    for (const auto& [key, value] : properties.items()) {
        const bool known = fields.contains(key) || std::find(extra.begin(), extra.end(), key) != extra.end();
        EXPECT_TRUE(known) << definition << "." << key << " is in the schema only";
    }
}

template <typename T>
void expectSameWords(const std::string& definition, const std::string& property)
{
    const Json node = Schema("scene.schema.json").root()["definitions"][definition];
    const Json words = property.empty() ? node["enum"] : node["properties"][property]["enum"];
    std::vector<std::string> expected;
    for (const char* word : EnumWords<T>::WORDS) {
        if (*word) expected.emplace_back(word);
    }
    EXPECT_EQ(words.get<std::vector<std::string>>(), expected) << definition << "." << property;
}

/// Calls visit(pointer, node) for every property of every object in the schema.
template <typename Visit>
void forEachProperty(const Json& node, const std::string& pointer, Visit&& visit)
{
    if (!node.is_object()) return;
    if (node.contains("properties") && node.contains("type")) {
        for (const auto& [key, property] : node["properties"].items()) visit(pointer + "/" + key, property);
    }
    for (const auto& [key, child] : node.items()) {
        if (child.is_object()) forEachProperty(child, pointer + "/" + key, visit);
    }
}

TEST(Schema, DefaultsAreThoseOfTheStructs)
{
    expectSameDefaults<Settings>("solver", {"preset"});
    expectSameDefaults<Material>("material", {"roughness", "metalness"});
    expectSameDefaults<CameraSettings>("camera", {"frame", "lookAt", "focusOn", "keys", "shake"});
    expectSameDefaults<CameraShake>("cameraShake");
    expectSameDefaults<LightSettings>("light", {"sky", "turbidity", "color", "skyColor", "groundColor"});
    expectSameDefaults<RenderSettings>("render", {"camera", "background", "fog", "colorScale", "title", "labels"});
    expectSameDefaults<Caption>("caption");
    expectSameDefaults<Collider>("planeCollider", {"type", "rotation", "motion", "roughness", "metalness", "floor"});
}

TEST(Schema, WordsAreThoseOfTheEnums)
{
    expectSameWords<SolverKind>("solver", "method");
    expectSameWords<RotationMethod>("solver", "rotation");
    expectSameWords<GridKind>("solver", "grid");
    expectSameWords<ReductionKind>("solver", "reduction");
    expectSameWords<VelocityOrder>("solver", "velocityOrder");
    expectSameWords<Quality>("render", "quality");
    expectSameWords<CameraKind>("camera", "kind");
    expectSameWords<Easing>("cameraKey", "easing");
    expectSameWords<ColorBy>("render", "colorBy");
    expectSameWords<Palette>("render", "palette");
    expectSameWords<TextPlace>("caption", "at");
    expectSameWords<DrawnAs>("material", "draw");
    expectSameWords<Finish>("finish", "");
    expectSameWords<FloorLook>("floorLook", "");
    expectSameWords<ToneMap>("render", "toneMap");
    expectSameWords<JointType>("jointTypes", "");
}

TEST(Schema, EveryFieldIsDescribedAndEveryObjectClosed)
{
    for (const char* file : {"scene.schema.json", "actor.schema.json", "joints.schema.json", "limits.schema.json",
                             "golden.schema.json", "sweep.schema.json"}) {
        const Schema schema(file);
        forEachProperty(schema.root(), file, [&](const std::string& pointer, const Json& property) {
            const Json& node = schema.resolve(property);
            EXPECT_TRUE(node.contains("description") || node.contains("const")) << pointer;
        });
        for (const auto& [name, node] : schema.root()["definitions"].items()) {
            if (node.value("type", "") != "object") continue;
            EXPECT_EQ(node["additionalProperties"], false) << file << " " << name;
        }
    }
}

TEST(Schema, GoldensHaveTheLimitsOfComparedImages)
{
    EXPECT_EQ(Schema("golden.schema.json").root()["definitions"]["limits"],
              Schema("limits.schema.json").root()["definitions"]["limits"]);
}

TEST(Schema, DefaultsKeepTheirOwnRules)
{
    Json scene = Json::parse(R"({"objects": [{"type": "rigid", "shape": "box"}]})");
    JsonFile file{"scene.json", scene};
    const Schema schema("scene.schema.json");
    schema.complete(file);
    JsonFile again = file;
    schema.complete(again);
    EXPECT_EQ(file.root, again.root);
    EXPECT_EQ(file.root["solver"]["substeps"], Settings{}.substeps);
    EXPECT_EQ(file.root["objects"][0]["repeat"]["counts"], Json({1, 1, 1}));
}

TEST(Schema, ReferencesAreCurrent)
{
    for (const auto& [page, schema] : {std::pair{"docs/scene.md", "scene"}, {"docs/sweep-plan.md", "sweep"}})
        // EXPECT_EQ would print the whole page on failure.
        EXPECT_TRUE(test::readText(test::inSource(page)) ==
                    schemaMarkdown(Schema(std::string(schema) + ".schema.json")))
            << "renew it: knuckle schema " << schema << " --markdown > " << page;
}

TEST(Schema, EveryReferenceLeadsToADefinition)
{
    const Schema schema("scene.schema.json");
    const std::string text(schema.text());
    for (size_t at = text.find("\"$ref\": \""); at != std::string::npos; at = text.find("\"$ref\": \"", at + 1)) {
        const size_t start = at + 9;
        const std::string reference = text.substr(start, text.find('"', start) - start);
        EXPECT_NO_THROW(schema.resolve(Json{{"$ref", reference}})) << reference;
    }
}

}  // namespace
}  // namespace knuckle
