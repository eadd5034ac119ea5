#include "render/draw_pass.h"

#include "shared/frame_types.h"
#include "sim/base/errors.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

/// Inputs of the pass that lights the picture.
struct LightingInputs {
    Buffer<gpu::FrameInput> frame{"frame", 1};
    Buffer<gpu::FrameView> view{"view", 1};
    Texture depth{"depthPicture", GL_DEPTH_COMPONENT32F, 16, 16}, surface{"surfacePicture", GL_RG32UI, 16, 16};
    Texture shade{"shadePicture", GL_R32UI, 8, 8}, lit{"litPicture", GL_RGBA8, 16, 16};
    Framebuffer target{"lighting", {&lit}, nullptr};

    std::string problemOf(const BufferTable& table, const std::vector<std::string>& reads) const
    {
        try {
            DrawPass(sharedGpu(), table, {"picture/screen", "picture/lighting"}, reads, target);
        } catch (const DeviceError& error) {
            return error.what();
        }
        return "";
    }
};

TEST(DrawPass, ReadsWhatItIsGivenByName)
{
    sharedGpu();
    LightingInputs inputs;
    BufferTable table;
    table.add(Lifetime::Scratch, inputs.frame, inputs.view);
    table.add(inputs.depth, inputs.surface, inputs.shade);
    EXPECT_EQ(inputs.problemOf(table, {"depthPicture", "surfacePicture", "shadePicture"}), "");
}

TEST(DrawPass, NamesWhatItDeclaresBesideItsInputs)
{
    sharedGpu();
    LightingInputs inputs;
    BufferTable table;
    table.add(Lifetime::Scratch, inputs.frame, inputs.view);
    table.add(inputs.depth, inputs.surface, inputs.shade);
    EXPECT_EQ(inputs.problemOf(table, {"depthPicture", "surfacePicture"}),
              "pass lighting declares \"shadePicture\", which is not among what it is given");
}

TEST(DrawPass, NamesAnInputThatDoesNotExist)
{
    sharedGpu();
    LightingInputs inputs;
    BufferTable table;
    table.add(Lifetime::Scratch, inputs.frame, inputs.view);
    EXPECT_EQ(inputs.problemOf(table, {"depthPicture"}),
              "pass lighting asks for \"depthPicture\", which is not in the table");
}

TEST(BufferTable, RefusesASecondBufferOfAName)
{
    sharedGpu();
    Buffer<float> first("masses", 4), second("masses", 4);
    BufferTable table;
    table.add(Lifetime::Scratch, first);
    EXPECT_THROW(table.add(Lifetime::Scratch, second), std::logic_error);
}

TEST(Kernel, NamesABlockOfAnotherTypeThanTheBuffers)
{
    sharedGpu();
    LightingInputs inputs;
    Buffer<float> positions("positions", 4);
    Buffer<gpu::ParticleBounds> boxes("particleBoxes", BOUNDS_THREADS);
    BufferTable table;
    table.add(Lifetime::Scratch, inputs.frame, positions, boxes);
    try {
        const Kernel kernel(sharedGpu(), table, "render/view/frame_bounds.comp");
        FAIL() << "positions are vectors in the shader";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find("kernel frame_bounds declares the block \"positions\""),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace knuckle::test
