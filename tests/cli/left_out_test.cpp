#include "tests/cli/cli_fixture.h"
#include "tests/places.h"
#include "tests/rig/import/edited_glb.h"

namespace knuckle {
namespace {

using Json = nlohmann::json;
using test::EditedGlb;
using test::RunResult;

/// Files of the project's figure with parts that are not read or not played, and the notes about them.
class LeftOut : public test::CliTest {
protected:
    static EditedGlb figure() { return EditedGlb(test::readText(test::inSource("assets/models/humanoid.glb"))); }
    /// Writes a scene with the figure as an actor. @param fields further ones.
    void write(EditedGlb& glb, const std::string& fields) const
    {
        folder.write("figure.glb", glb.bytes());
        folder.write("stage.json", R"({ "diameter": 0.08, "duration": 0.02, "render": { "width": 64, "height": 36 },
            "objects": [{ "type": "actor", "file": "figure.glb", "position": [0, 0, 0], )" +
                                       fields + "}] }");
    }
    /// Gives a clip a channel of values from zero to one. @param size of a value.
    static void animate(EditedGlb& glb, size_t clip, const Json& target, size_t size, const std::string& type)
    {
        Json& animation = glb.root["animations"].at(clip);
        const Json input = animation["samplers"].at(0)["input"];
        const size_t keys = glb.root["accessors"].at(input.get<size_t>())["count"];
        std::vector<float> values(keys * size, 1.0f);
        for (size_t i = 0; i < size; ++i) values[i] = 0.5f;
        const size_t output = glb.add(values, size, 5126, type);
        animation["channels"].push_back({{"sampler", animation["samplers"].size()}, {"target", target}});
        animation["samplers"].push_back({{"input", input}, {"output", output}});
    }
    static size_t nodeWith(const EditedGlb& glb, const char* field, const Json& value = {})
    {
        const Json& nodes = glb.root["nodes"];
        for (size_t n = 0; n < nodes.size(); ++n)
            if (nodes[n].contains(field) && (value.is_null() || nodes[n][field] == value)) return n;
        throw std::out_of_range(field);
    }
    /// Expects the note of voxelize, and of check for a scene that plays a clip and one that plays the other.
    void expectTold(EditedGlb& glb, const std::string& note) const
    {
        write(glb, R"("animation": { "clip": "walk" })");
        const RunResult voxelize = run({"voxelize", "figure.glb", "--diameter", "0.08"});
        EXPECT_EQ(voxelize.code, 0) << voxelize.err;
        EXPECT_NE(voxelize.out.find("\nnote: " + note + "\n"), std::string::npos) << voxelize.out;
        const RunResult check = run({"check", "stage.json"});
        EXPECT_EQ(check.code, 0) << check.err;
        EXPECT_NE((check.out + check.err).find(note), std::string::npos) << check.out << check.err;
        const RunResult other = run({"check", "stage.json", "--set", "objects.0.animation.clip=dance"});
        EXPECT_EQ(other.code, 0) << other.err;
        EXPECT_EQ((other.out + other.err).find(note), std::string::npos) << other.out << other.err;
    }
    static size_t walk(const EditedGlb& glb) { return glb.root["animations"].at(0)["name"] == "walk" ? 0 : 1; }
};

TEST_F(LeftOut, Ktx2PicturesAreWarnedOf)
{
    EditedGlb glb = figure();
    glb.add(std::vector<uint8_t>(80, 7), 1, 5121, "SCALAR");
    glb.root["images"] = Json::array(
        {{{"bufferView", glb.root["bufferViews"].size() - 1}, {"mimeType", "image/ktx2"}}});
    glb.root["textures"] = Json::array({{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}});
    glb.root["extensionsRequired"] = {"KHR_texture_basisu"};
    for (Json& material : glb.root["materials"]) material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    write(glb, R"("skin": "mesh")");
    const std::string warning = "warning: stage.json: /objects/0/skin: Texture 0 is a KTX2 picture, which is not read: "
                                "drawn plain.";
    const RunResult check = run({"check", "stage.json"});
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_NE(check.out.find("stage.json: warning: /objects/0/skin: Texture 0 is a KTX2"), std::string::npos)
        << check.out << check.err;
    const RunResult render = run({"render", "stage.json"});
    EXPECT_EQ(render.code, 0);
    EXPECT_NE(render.err.find(warning), std::string::npos) << render.err;
}

TEST_F(LeftOut, ExtensionsThatAFileRequiresAreWarnedOf)
{
    EditedGlb glb = figure();
    glb.root["extensionsRequired"] = {"VENDOR_rays"};
    write(glb, R"("skin": "mesh")");
    const std::string note = "The file requires 'VENDOR_rays', which is not known here: what it stands for is missing.";
    const std::string table = run({"voxelize", "figure.glb", "--diameter", "0.08"}).out;
    const size_t told = table.find("\nnote: " + note + "\n");
    EXPECT_NE(told, std::string::npos) << table;
    EXPECT_EQ(table.find(note, told + note.size()), std::string::npos) << "once";
    for (const RunResult& result : {run({"check", "stage.json"}), run({"render", "stage.json"})}) {
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_NE((result.out + result.err).find("warning: "), std::string::npos) << result.out << result.err;
        EXPECT_NE((result.out + result.err).find("/objects/0/skin: " + note), std::string::npos)
            << result.out << result.err;
    }
}

TEST_F(LeftOut, MorphWeightsOfAClip)
{
    EditedGlb glb = figure();
    const size_t node = nodeWith(glb, "mesh");
    Json& mesh = glb.root["meshes"].at(glb.root["nodes"][node]["mesh"].get<size_t>());
    for (Json& primitive : mesh["primitives"])
        primitive["targets"] = Json::array({{{"POSITION", primitive["attributes"]["POSITION"]}}});
    animate(glb, walk(glb), {{"node", node}, {"path", "weights"}}, 1, "SCALAR");
    expectTold(glb, "Clip 'walk' changes shapes (morph weights): they stay as at rest.");
}

TEST_F(LeftOut, ScaleKeysOfAClip)
{
    EditedGlb glb = figure();
    animate(glb, walk(glb), {{"node", nodeWith(glb, "name", "head")}, {"path", "scale"}}, 3, "VEC3");
    expectTold(glb, "Clip 'walk' scales head: bodies keep their size.");
}

TEST_F(LeftOut, NoClipOfTwoThatHaveOneName)
{
    EditedGlb glb = figure();
    for (Json& animation : glb.root["animations"]) animation["name"] = "mixamo.com";
    write(glb, R"("animation": { "clip": "mixamo.com" })");
    const std::string table = run({"voxelize", "figure.glb", "--diameter", "0.08"}).out;
    EXPECT_NE(table.find("\nclip: mixamo.com, "), std::string::npos) << table;
    EXPECT_NE(table.find("\nclip: mixamo.com#2, "), std::string::npos) << table;
    const auto places = [&](const std::string& clip) {
        const RunResult result = run({"-q", "render", "stage.json", "--export", "bodies=bodies.csv", "--set",
                                      "objects.0.animation.clip=\"" + clip + "\"", "--set",
                                      "objects.0.animation.start=0.3"});
        EXPECT_EQ(result.code, 0) << result.err;
        return test::readText(folder.path("bodies.csv"));
    };
    EXPECT_NE(places("mixamo.com"), places("mixamo.com#2"));
    const RunResult third = run({"check", "stage.json", "--set", "objects.0.animation.clip=\"mixamo.com#3\""});
    EXPECT_EQ(third.code, 2);
    EXPECT_NE(third.err.find("mixamo.com#2"), std::string::npos) << "what there is: " << third.err;
}

}  // namespace
}  // namespace knuckle
