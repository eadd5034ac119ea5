#include <algorithm>
#include <map>

#include "sim/base/errors.h"
#include "sim/gpu/program.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

size_t occurrences(const std::string& text, const std::string& part)
{
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

size_t lineCount(const std::string& text)
{
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The error message for a kernel that does not compile. Removes the driver's own message, which would be the next
/// error found.
std::string compileError(const std::string& path)
{
    std::string message = messageOf<DeviceError>([&] { Program::compute(gpu(), path); });
    messageOf<DeviceError>([] { gpu().checkErrors(); });
    return message;
}

}  // namespace

TEST(ShaderSource, IncludesEachFileOnce)
{
    TempFolder folder;
    folder.write("inner.glsl", "int inner;\n");
    folder.write("outer.glsl", "#include \"inner.glsl\"\nint outer;\n");
    folder.write("main.comp", "#include \"outer.glsl\"\n#include \"inner.glsl\"\n#include \"outer.glsl\"\nint own;\n");
    const ResolvedShader shader = ShaderSource(folder.path()).resolve("main.comp", {{"SIZE", "3"}});
    EXPECT_EQ(shader.text, "#version 430 core\n#define SIZE 3\nint inner;\nint outer;\nint own;\n");
}

TEST(ShaderSource, KnowsTheFileAndLineOfEveryLine)
{
    TempFolder folder;
    folder.write("part.glsl", "// about it\nint part;\n");
    folder.write("main.comp", "int first;\n#include \"part.glsl\"\nint last;\n");
    const ResolvedShader shader = ShaderSource(folder.path()).resolve("main.comp");
    ASSERT_EQ(shader.origins.size(), lineCount(shader.text));
    // #version, first, the two lines of the part, last
    const struct {
        size_t line;
        const char* file;
        int number;
    } rows[] = {{1, "main.comp", 1}, {2, "part.glsl", 1}, {3, "part.glsl", 2}, {4, "main.comp", 3}};
    for (const auto& row : rows) {
        EXPECT_EQ(shader.origins[row.line].file, row.file);
        EXPECT_EQ(shader.origins[row.line].line, row.number);
    }
}

TEST(ShaderSource, TranslatesTheLogsOfMesaAndNvidia)
{
    TempFolder folder;
    folder.write("part.glsl", "int part;\nint wrong\n");
    folder.write("main.comp", "#include \"part.glsl\"\nint last;\n");
    const ResolvedShader shader = ShaderSource(folder.path()).resolve("main.comp");
    EXPECT_EQ(shader.translate("0:3(5): error: syntax error\n0:4(1): warning: odd\n"),
              "shaders/part.glsl:2: error: syntax error\nshaders/main.comp:2: warning: odd\n");
    EXPECT_EQ(shader.translate("0(3) : error C0000: syntax error"), "shaders/part.glsl:2 : error C0000: syntax error");
    EXPECT_EQ(shader.translate("0:99(1): error: beyond the end"), "0:99(1): error: beyond the end");
    EXPECT_EQ(shader.translate("no place at all"), "no place at all");
}

TEST(ShaderSource, TheFolderOverridesTheProgramsOwnFilesOneByOne)
{
    TempFolder folder;
    std::filesystem::create_directories(folder.path("sim/common"));
    folder.write("sim/common/kernel.glsl", "// ours\n");
    const std::string overridden = ShaderSource(folder.path()).resolve("sim/common/grid/grid_count.comp").text;
    const std::string own = ShaderSource().resolve("sim/common/grid/grid_count.comp").text;
    EXPECT_EQ(occurrences(overridden, "// ours"), 1u);
    EXPECT_EQ(occurrences(overridden, "StepParameters"), 0u);
    EXPECT_EQ(occurrences(overridden, "void main()"), 1u) << "the kernel itself is the program's";
    EXPECT_GT(occurrences(own, "StepParameters"), 0u);
}

TEST(ShaderSource, AMissingFileIsNamed)
{
    EXPECT_EQ(messageOf<DeviceError>([] { ShaderSource("elsewhere").resolve("sim/nothing.comp"); }),
              "shader sim/nothing.comp is neither in the program nor in \"elsewhere\"");
}

TEST(Program, AnErrorInAnIncludedFileNamesThatFileAndLine)
{
    shaderFolder().write("broken.glsl", "int fine;\n\nfloat broken = notDeclared;\n");
    shaderFolder().write("broken.comp", "layout(local_size_x = 1) in;\n#include \"broken.glsl\"\nvoid main() {}\n");
    const std::string message = compileError("broken.comp");
    EXPECT_TRUE(message.starts_with("shader broken.comp does not compile on " + gpu().device().name)) << message;
    EXPECT_NE(message.find("shaders/broken.glsl:3"), std::string::npos) << message;
    EXPECT_NE(message.find("notDeclared"), std::string::npos) << message;
}

TEST(Program, AnErrorAfterAnIncludeNamesTheLineOfTheFileItself)
{
    shaderFolder().write("late.comp", "#include \"sim/common/kernel.glsl\"\nlayout(local_size_x = 1) in;\n"
                                      "void main()\n{\n    missing();\n}\n");
    const std::string message = compileError("late.comp");
    EXPECT_NE(message.find("shaders/late.comp:5"), std::string::npos) << message;
}

TEST(Kernel, ABufferThatTheSolverDoesNotHaveIsNamedWithItsKernel)
{
    std::filesystem::create_directories(shaderFolder().path("sim"));
    const std::string head = "#include \"sim/common/kernel.glsl\"\nlayout(local_size_x = 1) in;\n";
    shaderFolder().write("sim/stores.comp", head + "BUFFER(uint, Marbles, marbles);\n"
                                                   "void main() { marbles[0] = sim.particleCount; }\n");
    shaderFolder().write("sim/reads.comp", head + "BUFFER(uint, CellCounts, cellCounts);\n"
                                                  "uniform usamplerBuffer pebbles;\n"
                                                  "void main() { cellCounts[0] = texelFetch(pebbles, 0).x; }\n");
    KernelFixture fixture(mixedWorld());
    EXPECT_EQ(messageOf<DeviceError>([&] { fixture.load("stores"); }),
              "kernel stores declares \"marbles\", which is not among what it is given");
    EXPECT_EQ(messageOf<DeviceError>([&] { fixture.load("reads"); }),
              "kernel reads declares \"pebbles\", which is not among what it is given");
}

TEST(Kernel, IsGivenWhatItsNamesAreRenamedTo)
{
    const Gpu& device = gpu();  // before there are buffers
    std::filesystem::create_directories(shaderFolder().path("sim"));
    shaderFolder().write("sim/renamed.comp", "layout(local_size_x = 1) in;\n"
                                             "layout(std430) buffer Cells { uint cells[]; };\n"
                                             "layout(std430) buffer CellCounts { uint cellCounts[]; };\n"
                                             "layout(std430) buffer Cellars { uint cellars[]; };\n"
                                             "uniform usamplerBuffer cellStarts;\n"
                                             "void main()\n{\n    cells[0] = cellCounts[0] = cellars[0] = 7u + "
                                             "texelFetch(cellStarts, 0).x;\n}\n");
    std::map<std::string, Buffer<uint32_t>> buffers;
    BufferTable table;
    for (const char* name :
         {"cells", "cellCounts", "cellars", "cellStarts", "fluidCellCounts", "fluidCellars", "fluidCellStarts"}) {
        Buffer<uint32_t>& buffer = buffers[name] = Buffer<uint32_t>(name, 1);
        table.add(Lifetime::Scratch, buffer);
    }
    const uint32_t two = 2;
    buffers["fluidCellStarts"].upload({&two, 1});
    const Renames renames{{"cell", "fluidCell"}};
    KernelTimer timer;
    Kernel(device, table, "sim/renamed.comp", {}, {}, renames).dispatch(timer, 1);
    const auto valueOf = [&](const char* name) { return buffers[name].download()[0]; };
    EXPECT_EQ(valueOf("fluidCellCounts"), 9u) << "by a sampler and a block that are renamed";
    EXPECT_EQ(valueOf("cellCounts"), 0u);
    EXPECT_EQ(valueOf("cells"), 9u) << "another word";
    EXPECT_EQ(valueOf("cellars"), 9u) << "another word";
    EXPECT_EQ(valueOf("fluidCellars"), 0u);
    EXPECT_EQ(messageOf<DeviceError>([&] {
                  Kernel(device, table.only({"cells", "cellCounts", "cellars", "cellStarts"}, "test"),
                         "sim/renamed.comp", {}, {}, renames);
              }),
              "kernel renamed declares \"fluidCellCounts\", which is not among what it is given");
}

TEST(Kernel, GroupsCoverTheThreads)
{
    EXPECT_EQ(groupsFor(0), 0u);
    EXPECT_EQ(groupsFor(1), 1u);
    EXPECT_EQ(groupsFor(GROUP_SIZE), 1u);
    EXPECT_EQ(groupsFor(GROUP_SIZE + 1), 2u);
}

TEST(DeviceChoice, ReadsWordsAndIndices)
{
    EXPECT_EQ(DeviceChoice::parse("auto").kind, DeviceChoice::Kind::Auto);
    EXPECT_EQ(DeviceChoice::parse("gpu").kind, DeviceChoice::Kind::Gpu);
    EXPECT_EQ(DeviceChoice::parse("software").kind, DeviceChoice::Kind::Software);
    EXPECT_EQ(DeviceChoice::parse("12").kind, DeviceChoice::Kind::Index);
    EXPECT_EQ(DeviceChoice::parse("12").index, 12u);
}

TEST(DeviceChoice, RefusesEverythingElse)
{
    for (const char* text : {"", "Auto", "gpu ", "-1", "1.5", "0x1", "99999999999"})
        EXPECT_EQ(messageOf<InputError>([&] { DeviceChoice::parse(text); }),
                  "--device: \"" + std::string(text) +
                      "\" is not a device; use auto, gpu, software or an index from `knuckle info`");
}

TEST(RawBuffer, GivesBackWhatItWasGivenAndStartsEmpty)
{
    gpu();
    Buffer<uint32_t> buffer("numbers", 5);
    EXPECT_EQ(buffer.download(), (std::vector<uint32_t>{0, 0, 0, 0, 0}));
    const std::vector<uint32_t> values = {1, 2, 3, 4, 0xffffffffu};
    buffer.upload(std::span<const uint32_t>(values));
    EXPECT_EQ(buffer.download(), values);
    buffer.clear();
    EXPECT_EQ(buffer.download(), (std::vector<uint32_t>{0, 0, 0, 0, 0}));
    EXPECT_EQ(buffer.label(), "numbers");
    Buffer<uint32_t> none("none", size_t{0});
    EXPECT_GE(none.bytes(), 16u) << "an empty array still binds";
    EXPECT_TRUE(none.download().empty());
}

}  // namespace knuckle::test
