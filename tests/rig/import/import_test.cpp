#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/gltf/glb.h"
#include "sim/rig/gltf/gltf_clips.h"
#include "sim/rig/import/child_process.h"
#include "sim/rig/import/import.h"
#include "sim/rig/import/model_bytes.h"
#include "tests/rig/shapes.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle {
namespace {

// A folder of its own for each test.
class Import : public testing::Test {
protected:
    Import()
    {
        std::string name = (std::filesystem::temp_directory_path() / "knuckle-import-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~Import() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& content) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return (folder_ / name).string();
    }
    std::string refusal(const std::string& path, const ImportOptions& options = {}) const
    {
        try {
            importModel(path, options);
        } catch (const InputError& error) {
            return error.what();
        }
        return "was read";
    }
    // Expects an error of one line that begins with the file's name.
    void expectRefused(const std::string& path, const std::string& part) const
    {
        const std::string message = refusal(path);
        EXPECT_TRUE(message.starts_with(path)) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    std::filesystem::path folder_;
};

std::string cubeObj(const std::string& scale = "1")
{
    std::string text;
    for (int i = 0; i < 8; ++i) {
        for (const int bit : {1, 2, 4}) {
            text += (bit == 1 ? "v " : " ") + ((i & bit) ? scale : std::string("0"));
        }
        text += "\n";
    }
    return text + "f 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 3 4\nf 1 4 2\n"
                  "f 5 6 8\nf 5 8 7\n";
}

const char* const WALKER_BVH = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 90 0\n"
                               " CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                               " JOINT Chest\n {\n  OFFSET 0 40 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n"
                               "  End Site\n  {\n   OFFSET 0 40 0\n  }\n }\n"
                               " JOINT LeftLeg\n {\n  OFFSET 15 -10 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n"
                               "  End Site\n  {\n   OFFSET 5 -80 0\n  }\n }\n}\n";

std::string walker(const std::string& frames, const std::string& row)
{
    return std::string(WALKER_BVH) + "MOTION\nFrames: " + frames + "\nFrame Time: 0.05\n" + row + "\n" + row + "\n";
}

// The limit on memory is off with the address sanitizer, which ends the child in its own way.
#if defined(__SANITIZE_ADDRESS__)
const char* const MEMORY = "the importer";
#else
const char* const MEMORY = "memory";
#endif

const std::string STILL = "0 90 0 0 0 0 0 0 0 0 0 0";

// The humanoid's file with a part of its JSON or its numbers replaced by text of the same length.
std::string damaged(const std::string& from, const std::string& to)
{
    std::string glb = toGlb(makeHumanoid());
    const size_t at = glb.find(from);
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(from.size(), to.size());
    return glb.replace(at, from.size(), to);
}

TEST_F(Import, objWithoutASkeletonIsOneRigidBody)
{
    const Model model = importModel(write("cube.obj", cubeObj()));
    EXPECT_EQ(model.triangles.size(), 12u);
    EXPECT_TRUE(model.bones.empty());
    EXPECT_TRUE(model.skin.empty());
    EXPECT_EQ(model.name, "cube");
    EXPECT_EQ(makeActor(model, {.name = {}, .voxels = {.diameter = 0.11f}, .articulation = {}}).bodies.size(), 1u);
}

TEST_F(Import, skinOfAGltfFileComesBackNormalized)
{
    const Model model = importModel(write("humanoid.glb", toGlb(makeHumanoid())));
    ASSERT_EQ(model.skin.size(), model.vertices.size());
    for (const SkinWeights& skin : model.skin) {
        float sum = 0.0f;
        for (float weight : skin.weights) {
            sum += weight;
        }
        ASSERT_NEAR(sum, 1.0f, 1e-6f);
    }
}

TEST_F(Import, bvhWithoutAMeshBecomesARagdollOfAPersonsSize)
{
    const Model model = importModel(write("walker.bvh", walker("2", STILL)));
    EXPECT_EQ(model.bones.size(), 5u);  // the end sites count
    ASSERT_EQ(model.clips.size(), 1u);
    float low = 1e9f, high = -1e9f;
    for (const Eigen::Vector3f& v : model.vertices) {
        low = std::min(low, v.y());
        high = std::max(high, v.y());
    }
    // 170 units from end to end, read as centimetres, and the caps beyond.
    EXPECT_GT(high - low, 1.7f);
    EXPECT_LT(high - low, 2.1f);
    const Actor actor = makeActor(model, {.name = {}, .voxels = {.diameter = 0.05f}, .articulation = {}});
    EXPECT_EQ(actor.bodies.size(), 3u);
}

TEST_F(Import, modelFarTooLargeForMetresIsTakenForCentimetresAndNoted)
{
    const Model model = importModel(write("big.obj", cubeObj("180")));
    float largest = 0.0f;
    for (const Eigen::Vector3f& v : model.vertices) {
        largest = std::max(largest, v.maxCoeff());
    }
    EXPECT_NEAR(largest, 1.8f, 1e-5f);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_NE(model.notes[0].find("centimetres"), std::string::npos);
}

TEST_F(Import, givenScaleIsTaken)
{
    const Model model = importModel(write("cube.obj", cubeObj()), {.fit = {.scale = 0.25}, .clips = false});
    float largest = 0.0f;
    for (const Eigen::Vector3f& v : model.vertices) {
        largest = std::max(largest, v.maxCoeff());
    }
    EXPECT_FLOAT_EQ(largest, 0.25f);
    EXPECT_TRUE(model.notes.empty());
}

TEST_F(Import, twoRunsGiveTheSameModel)
{
    const std::string path = write("humanoid.glb", toGlb(makeHumanoid()));
    EXPECT_EQ(toBytes(importModel(path)), toBytes(importModel(path)));
}

TEST_F(Import, missingFileFolderAndEmptyFileAreRefused)
{
    expectRefused((folder_ / "nothing.glb").string(), "no such file");
    expectRefused(folder_.string(), "not a file");
    expectRefused(write("empty.glb", ""), "empty");
}

TEST_F(Import, whatIsNotAModelIsRefused)
{
    expectRefused(write("text.txt", "hello"), "cannot be read");
    expectRefused(write("text.glb", "hello, I am no model at all"), "");
    expectRefused(write("text.fbx", std::string(5000, 'x')), "");
    expectRefused(write("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "");
}

TEST_F(Import, truncatedFileIsRefused)
{
    const std::string whole = toGlb(makeHumanoid());
    for (const size_t size : {size_t{10}, size_t{200}, whole.size() / 2, whole.size() - 1000}) {
        expectRefused(write("cut.glb", whole.substr(0, size)), size < 100 ? "" : "cut off");
    }
    expectRefused(write("cut.bvh", std::string(WALKER_BVH).substr(0, 150)), "");
}

TEST_F(Import, verticesThatAreNotNumbersAreRefused)
{
    expectRefused(write("nan.obj", cubeObj("nan")), "");
    std::string glb = toGlb(makeHumanoid());
    const uint32_t notANumber = 0x7fc00000;
    uint32_t jsonSize = 0;
    std::memcpy(&jsonSize, glb.data() + 12, 4);
    std::memcpy(glb.data() + 28 + jsonSize + 1200, &notANumber, 4);  // positions come first in the binary chunk
    expectRefused(write("nan.glb", glb), "not finite");
}

TEST_F(Import, boneCycleIsRefused)
{
    // Makes the hips a child of the head: a cycle.
    expectRefused(write("ring.glb", damaged("\"children\":[4]", "\"children\":[0]")), "");
}

TEST_F(Import, singularBindMatrixIsRefused)
{
    std::string glb = toGlb(makeHumanoid());
    const Eigen::Matrix4f bind = rigidPose(makeHumanoid().bones[HEAD].restPose).inverse();
    const size_t at = glb.find(std::string(reinterpret_cast<const char*>(bind.data()), sizeof bind));
    ASSERT_NE(at, std::string::npos);
    glb.replace(at, 4 * sizeof(float), 4 * sizeof(float), '\0');  // its first column
    expectRefused(write("flat.glb", glb), "singular");
}

TEST_F(Import, hugeCountsEndInOneLine)
{
    expectRefused(write("frames.bvh", walker("2147483647", STILL)), MEMORY);
    expectRefused(write("count.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                                     "property float y\nproperty float z\nelement face 4000000000\n"
                                     "property list uchar int vertex_indices\nend_header\n0 0 0\n"),
                  "");
}

TEST_F(Import, absurdScaleIsRefusedWithTheRemedy)
{
    expectRefused(write("huge.obj", cubeObj("1e12")), "scale");
    expectRefused(write("tiny.obj", cubeObj("1e-9")), "scale");
    EXPECT_NE(refusal(write("cube.obj", cubeObj()), {.fit = {.scale = -1.0}}), "was read");
}

TEST_F(Import, messagesNameNoControlCharacters)
{
    const std::string path = write("odd.glb", std::string("glTF\2\0\0\0\377\377\377\377\33[31m", 17));
    for (const char c : refusal(path)) {
        EXPECT_GE(static_cast<unsigned char>(c), 0x20);
    }
}

TEST(ChildProcess, resultComesBackWhole)
{
    const ChildResult result = runInChild([] { return std::vector<uint8_t>(3000000, 7); }, {});
    EXPECT_TRUE(result.ok);
    EXPECT_EQ(result.bytes, std::vector<uint8_t>(3000000, 7));
}

TEST(ChildProcess, crashMemoryTimeAndSizeBecomeSentences)
{
    const ChildLimits limits{.extraMemory = 64u << 20, .seconds = 1, .maxResult = 1000};
    const auto failure = [&](const std::function<std::vector<uint8_t>()>& work) {
        const ChildResult result = runInChild(work, limits);
        EXPECT_FALSE(result.ok);
        return result.failure;
    };
    EXPECT_NE(failure([]() -> std::vector<uint8_t> { std::abort(); }).find("crashed"), std::string::npos);
    EXPECT_NE(failure([]() -> std::vector<uint8_t> { throw 1; }), "");
    EXPECT_NE(failure([] { return std::vector<uint8_t>(5000); }).find("holds more"), std::string::npos);
    EXPECT_NE(failure([]() -> std::vector<uint8_t> {
                  volatile bool forever = true;
                  while (forever) {
                  }
                  return {};
              }).find("more than 1 s"),
              std::string::npos);
#if !defined(__SANITIZE_ADDRESS__)
    EXPECT_NE(failure([] { return std::vector<uint8_t>(1u << 30); }).find("memory"), std::string::npos);
#endif
}

TEST(ModelBytes, damagedBytesAreNoModel)
{
    const std::vector<uint8_t> bytes = toBytes(makeHumanoid());
    Model model;
    EXPECT_TRUE(fromBytes(bytes, model));
    EXPECT_FALSE(fromBytes(std::span(bytes).first(bytes.size() - 1), model));
    std::vector<uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_FALSE(fromBytes(longer, model));
    std::vector<uint8_t> hugeCount = bytes;
    std::fill_n(hugeCount.begin() + 16, 6, uint8_t{0xff});  // the count of vertices, after the name
    EXPECT_FALSE(fromBytes(hugeCount, model));
}

}  // namespace
}  // namespace knuckle
