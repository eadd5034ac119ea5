#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/spheres/palette.h"
#include "shared/frame_types.h"
#include "sim/base/errors.h"
#include "sim/gpu/program.h"
#include "tests/render/render_fixture.h"

namespace knuckle::test {
namespace {

World twoCubes()
{
    StillWorld still(0.1f);
    still.addGround();
    still.addBody(cubeLattice(3, 0.2f), {0, 0.3f, 0});
    still.addBody(cubeLattice(3, 0.2f), {0.1f, 1.2f, 0});
    return still.world;
}

RenderSettings tiny()
{
    RenderSettings settings;
    settings.width = 96;
    settings.height = 54;
    return settings;
}

TEST(Renderer, DrawsTheSameStateToTheSameBits)
{
    EXPECT_EQ(drawn(twoCubes(), tiny()).rgb, drawn(twoCubes(), tiny()).rgb);
}

TEST(Renderer, HandsOutEachFinishedPictureOnce)
{
    RenderSettings settings = tiny();
    settings.camera.kind = CameraKind::Orbit;
    settings.camera.orbitSpeed = 90.0f;
    const World world = twoCubes();
    Gpu& gpu = sharedGpu();
    const StillBuffers buffers(world);
    Renderer renderer(gpu, world, settings);
    EXPECT_THROW(renderer.readImage(), RunError);
    renderer.draw(buffers.view(), 0.0);
    const Image first = renderer.readImage();
    EXPECT_EQ(renderer.readImage().rgb, first.rgb) << "asked again";
    renderer.draw(buffers.view(), 1.0);
    EXPECT_NE(renderer.readImage().rgb, first.rgb);
}

TEST(Renderer, StandsWhereItIsTold)
{
    const Eigen::Vector3f place(2, 1, 3), target(0, 0.5f, 0);
    RenderSettings there = tiny(), orbiting = tiny();
    there.camera.automatic = false;
    there.camera.position = place;
    there.camera.target = target;
    orbiting.camera.kind = CameraKind::Orbit;
    const World world = twoCubes();
    Gpu& gpu = sharedGpu();
    const StillBuffers buffers(world);
    Renderer renderer(gpu, world, orbiting);
    renderer.draw(buffers.view(), 0.0);
    renderer.setCamera(place, target);
    renderer.draw(buffers.view(), 1.0);
    EXPECT_EQ(renderer.readImage().rgb, drawn(world, there).rgb);
    EXPECT_LT((renderer.camera().toWorld.translation().cast<float>() - place).norm(), 1e-5f);
    EXPECT_THROW(renderer.setCamera(place, place), std::logic_error);
}

TEST(Renderer, DrawsOddSizesAndNoParticlesAtAll)
{
    StillWorld still(0.1f);
    still.addGround();
    RenderSettings settings = tiny();
    settings.width = 37;
    settings.height = 19;
    const Image image = drawn(still.world, settings);
    EXPECT_EQ(image.rgb.size(), size_t{37} * 19 * 3);
}

TEST(Renderer, NeitherDrawsNorFramesWhatIsUnseen)
{
    StillWorld one(0.1f), two(0.1f);
    for (StillWorld* still : {&one, &two}) {
        still->addGround();
        still->addBody(cubeLattice(3, 0.2f), {0, 0.3f, 0});
    }
    two.addBody(cubeLattice(3, 0.2f), {1.0f, 3.0f, 0});
    RenderSettings settings = tiny();
    settings.colorBy = ColorBy::Material;
    EXPECT_NE(drawn(two.world, settings).rgb, drawn(one.world, settings).rgb);
    two.world.unseen = {{27, 54}};
    EXPECT_EQ(drawn(two.world, settings).rgb, drawn(one.world, settings).rgb);
}

TEST(Renderer, DrawsFluidsInTheirOwnSize)
{
    RenderSettings settings = tiny();
    settings.camera.automatic = false;
    settings.camera.position = {0, 0, 1};
    settings.camera.target = {0, 0, 0};
    settings.camera.fieldOfView = 30.0f;
    StillWorld solid(0.2f), fluid(0.2f);
    solid.addBody({{0, 0, 0}}, {0, 0, 0});
    fluid.world.fluidSpacing = 0.2f;
    fluid.world.materials[0].look.drawn = DrawnAs::Particles;
    addFluid(fluid.world, {{0, 0, 0}});
    // In front of the sky only: counts pixels that differ from those without the particle.
    const auto covered = [&](const World& world) {
        const Image image = drawn(world, settings), sky = drawn(StillWorld(0.2f).world, settings);
        double count = 0;
        for (size_t k = 0; k < image.rgb.size(); k += 3)
            count += !std::equal(&image.rgb[k], &image.rgb[k] + 3, &sky.rgb[k]);
        return count;
    };
    // Ratio of their radii, 0.2 and 0.58 x 0.2 m, seen from 1 m: sin^2 of the angles. Edges are uncertain by a pixel.
    EXPECT_NEAR(std::sqrt(covered(fluid.world) / covered(solid.world)), 0.58, 0.04);
}

TEST(Renderer, DoesNotDrawWhatIsParked)
{
    World world = twoCubes();
    const Image without = drawn(world, tiny());
    Emitter emitter;
    emitter.pool = 1;
    world.emitters.push_back(emitter);
    addFluid(world, {{0.1f, 0.75f, 0.4f}});  // between the cubes, for all to see
    EXPECT_EQ(drawn(world, tiny()).rgb, without.rgb);
    world.emitters.clear();
    EXPECT_NE(drawn(world, tiny()).rgb, without.rgb);
}

template <typename Change>
void expectRefused(Change change)
{
    RenderSettings settings = tiny();
    change(settings);
    const World world = twoCubes();
    EXPECT_THROW(Renderer(sharedGpu(), world, settings), InputError);
}

TEST(Renderer, RefusesSettingsOutOfRange)
{
    expectRefused([](RenderSettings& s) { s.width = 15; });
    expectRefused([](RenderSettings& s) { s.height = 8193; });
    expectRefused([](RenderSettings& s) { s.antialiasing = 0; });
    expectRefused([](RenderSettings& s) { s.exposure = 0.0f; });
    expectRefused([](RenderSettings& s) { s.light.direction.setZero(); });
    expectRefused([](RenderSettings& s) { s.camera.fieldOfView = 121.0f; });
    expectRefused([](RenderSettings& s) {
        s.camera.automatic = false;
        s.camera.target = s.camera.position;
    });
    expectRefused([](RenderSettings& s) {
        s.camera.kind = CameraKind::Follow;
        s.camera.follow = "nobody";
    });
}

TEST(Renderer, RefusesAViewOfAnotherWorld)
{
    const World world = twoCubes();
    Gpu& gpu = sharedGpu();
    const StillBuffers buffers(world);
    ParticleView view = buffers.view();
    view.particleCount -= 1;
    Renderer renderer(gpu, world, tiny());
    EXPECT_THROW(renderer.draw(view, 0.0), RunError);
}

struct Member {
    const char* name;
    size_t offset;
};

void expectOffsets(const Program& program, const char* block, size_t size, std::initializer_list<Member> members)
{
    const GLuint index = glGetProgramResourceIndex(program.id(), GL_UNIFORM_BLOCK, block);
    ASSERT_NE(index, GL_INVALID_INDEX) << block;
    const GLenum sizeProperty = GL_BUFFER_DATA_SIZE, offsetProperty = GL_OFFSET;
    GLint value = 0;
    glGetProgramResourceiv(program.id(), GL_UNIFORM_BLOCK, index, 1, &sizeProperty, 1, nullptr, &value);
    EXPECT_EQ(static_cast<size_t>(value), size) << block;
    for (const Member& member : members) {
        const GLuint uniform = glGetProgramResourceIndex(program.id(), GL_UNIFORM, member.name);
        ASSERT_NE(uniform, GL_INVALID_INDEX) << member.name;
        glGetProgramResourceiv(program.id(), GL_UNIFORM, uniform, 1, &offsetProperty, 1, nullptr, &value);
        EXPECT_EQ(static_cast<size_t>(value), member.offset) << member.name;
    }
}

TEST(Renderer, HostAndDriverAgreeOnTheFramesBlocks)
{
    const Program program = Program::graphics(sharedGpu(), "render/picture/screen.vert",
                                              "render/picture/lighting.frag");
    using gpu::FrameInput;
    using gpu::FrameView;
    expectOffsets(program, "Frame", sizeof(FrameInput),
                  {{"frame.keyDirection", offsetof(FrameInput, keyDirection)},
                   {"frame.solidHigh", offsetof(FrameInput, solidHigh)},
                   {"frame.width", offsetof(FrameInput, width)},
                   {"frame.radius", offsetof(FrameInput, radius)},
                   {"frame.groundFade", offsetof(FrameInput, groundFade)}});
    expectOffsets(program, "View", sizeof(FrameView),
                  {{"view.cameraPosition", offsetof(FrameView, cameraPosition)},
                   {"view.lightDepth", offsetof(FrameView, lightDepth)},
                   {"view.upInView", offsetof(FrameView, upInView)}});
}

TEST(Palette, NeighboursDifferAndColoursAreInRange)
{
    for (uint32_t i = 0; i < 1000; ++i) {
        const Vector3f color = paletteColor(i), next = paletteColor(i + 1);
        EXPECT_GE(color.minCoeff(), 0.0f);
        EXPECT_LE(color.maxCoeff(), 1.0f);
        EXPECT_GT((color - next).norm(), 0.15f) << i;
    }
}

TEST(Palette, SharedParticlesAreRedOnlyWhenAskedFor)
{
    World world = twoCubes();
    world.particles[3].bodyCount = 2;
    RenderSettings settings;
    EXPECT_EQ(particleColors(world, settings)[3], particleColors(world, settings)[4]);
    settings.highlightJoints = true;
    EXPECT_NE(particleColors(world, settings)[3], particleColors(world, settings)[4]);
    EXPECT_GT(particleColors(world, settings)[3] & 0xffu, 200u);
}

}  // namespace
}  // namespace knuckle::test
