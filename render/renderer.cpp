#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/colliders/static_geometry.h"
#include "render/pass_scope.h"
#include "render/picture/picture_reader.h"
#include "render/picture/render_targets.h"
#include "render/spheres/sphere_pass.h"
#include "render/view/camera.h"

// A frame:
//   frame_bounds, frame_camera   aim the camera on the GPU, since only it knows the positions
//   frame_view                   fits the shadow map
//   burial_*, sphere_cull/offsets/list   which particles can be seen, and from where
//   sphere_shadow, collider_shadow   what the key light sees
//   plane, collider, sphere      normal, colour and depth of what the camera sees
//   occlusion                    ambient and key light that arrives, at half resolution
//   lighting                     colours, ready to be seen
//   edge_filter, resolve         antialiasing
namespace knuckle {

namespace {

constexpr float DEGREE = std::numbers::pi_v<float> / 180.0f;
/// View depth of the depth buffer's 1 [m]; depth is linear in floats, so it can be generous.
constexpr float FAR_DEPTH = 20000.0f;
const Vector3f KEY_TINT{1.0f, 0.955f, 0.89f};
const Vector3f GROUND_ALBEDO{0.5f, 0.5f, 0.5f};

gpu::vec4 vec4Of(const Vector3f& v, float w = 0.0f)
{
    return {v.x(), v.y(), v.z(), w};
}

/// 1, 2 or 5 times a power of ten, at most `size`.
float roundLength(float size)
{
    const float power = std::pow(10.0f, std::floor(std::log10(size)));
    return power * (size >= 5.0f * power ? 5.0f : size >= 2.0f * power ? 2.0f : 1.0f);
}

}  // namespace

struct Renderer::Impl {
    Impl(Gpu& device, const World& world, const RenderSettings& chosen);
    ~Impl() { glDeleteVertexArrays(1, &emptyArray); }

    void fillInput(const World& world);
    void attach(const ParticleView& view);
    void aimCamera(double time);
    void fitView();
    void drawShadowMap();
    void drawGeometry();
    void drawOcclusion();
    void drawPicture();
    void smoothEdges();
    void fullScreen(const char* name, const Framebuffer& target, const Program& program);

    Gpu& gpu;
    RenderSettings settings;
    SceneExtent extent;
    Camera camera;
    RenderTargets targets;
    StaticGeometry solids;
    SpherePass spheres;
    PictureReader reader;
    Program bounds, frameCamera, frameView, occlusion, lighting, edgeFilter, resolve;
    std::optional<double> lookedAt;    ///< Time of the state that the camera saw last [s].
    gpu::FrameInput input{};
    Buffer<gpu::FrameInput> inputBuffer{"frame input", 1};
    Buffer<gpu::FrameView> viewBuffer{"frame view", 1};
    Buffer<gpu::ParticleBounds> boundsBuffer{"particle bounds", BOUNDS_THREADS};
    KernelTimer timer;
    GLuint emptyArray = 0;
};

Renderer::Impl::Impl(Gpu& device, const World& world, const RenderSettings& chosen)
    : gpu(device), settings((checkSettings(chosen), chosen)), extent(sceneExtent(world)),
      camera(settings.camera, world, float(settings.width) / float(settings.height)),
      targets(settings.width, settings.height, settings.antialiasing), solids(gpu, world, extent),
      spheres(gpu, world, settings), reader(settings.width, settings.height),
      bounds(Program::compute(gpu, "render/view/frame_bounds.comp")),
      frameCamera(Program::compute(gpu, "render/view/frame_camera.comp")),
      frameView(Program::compute(gpu, "render/view/frame_view.comp")),
      occlusion(Program::graphics(gpu, "render/picture/screen.vert", "render/picture/occlusion.frag")),
      lighting(Program::graphics(gpu, "render/picture/screen.vert", "render/picture/lighting.frag")),
      edgeFilter(Program::graphics(gpu, "render/picture/edge_tile.vert", "render/picture/edge_filter.frag")),
      resolve(Program::graphics(gpu, "render/picture/screen.vert", "render/picture/resolve.frag"))
{
    glGenVertexArrays(1, &emptyArray);
    fillInput(world);
    gpu.checkErrors();
}

void Renderer::Impl::fillInput(const World& world)
{
    const LightSettings& light = settings.light;
    input.keyDirection = vec4Of(light.direction.normalized(), std::tan(light.softness * DEGREE));
    input.keyColor = vec4Of(KEY_TINT * light.intensity);
    input.skyColor = vec4Of(light.skyColor);
    input.groundColor = vec4Of(light.groundColor, settings.exposure);
    input.groundAlbedo = vec4Of(GROUND_ALBEDO, extent.ground);
    input.shadowLimitLow = vec4Of(extent.limit.min());
    input.shadowLimitHigh = vec4Of(extent.limit.max());
    input.solidLow = vec4Of(extent.solids.min());
    input.solidHigh = vec4Of(extent.solids.max());
    input.width = settings.width * settings.antialiasing;
    input.height = settings.height * settings.antialiasing;
    input.particleCount = static_cast<uint32_t>(world.particles.size());
    input.cameraMode = camera.mode();
    input.followedBodyStart = camera.followed().start;
    input.followedBodyCount = camera.followed().count;
    input.tanHalfFov = camera.tanHalfFov();
    input.farDepth = FAR_DEPTH;
    input.pointSizeLimit = spheres.pointSizeLimit();
    input.speedScale = settings.speedScale;
    input.shadowSize = static_cast<float>(SHADOW_SIZE);
    input.occlusionRadius = std::clamp(0.05f * extent.size, 4.0f * world.particleRadius, 14.0f * world.particleRadius);
    input.patternScale = roundLength(0.25f * extent.size);
    input.groundFade = 9.0f * extent.size;
}

void Renderer::Impl::attach(const ParticleView& view)
{
    input.radius = view.radius;
    input.solidCount = std::min(view.solidCount, view.particleCount);
    input.fluidRadius = FLUID_RADIUS * view.fluidSpacing;
    input.fluidShare = static_cast<uint32_t>(
        std::round(static_cast<float>(SPACE_UNITS) * std::pow(0.5f * view.fluidSpacing / view.radius, 3.0f)));
    spheres.attach(view);
    glBindBufferBase(GL_UNIFORM_BUFFER, FRAME_INPUT_SLOT, inputBuffer.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, FRAME_VIEW_SLOT, viewBuffer.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_POSITIONS_SLOT, view.positions);
    if (view.bodyCentres != 0) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_CENTRES_SLOT, view.bodyCentres);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_BOUNDS_SLOT, boundsBuffer.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, RENDER_VIEW_SLOT, viewBuffer.id());
    // The solver's last step wrote what all of the following read.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Renderer::Impl::aimCamera(double time)
{
    const PassScope scope(timer, "frame_camera");
    const CameraAim aim = camera.at(time);
    input.cameraPosition = vec4Of(aim.position);
    input.cameraTarget = vec4Of(aim.target);
    input.trackSeconds = lookedAt ? static_cast<float>(std::max(0.0, time - *lookedAt)) : -1.0f;
    lookedAt = time;
    inputBuffer.upload({&input, 1});
    glUseProgram(bounds.id());
    glDispatchCompute(BOUNDS_THREADS / RENDER_GROUP_SIZE, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glUseProgram(frameCamera.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Renderer::Impl::fitView()
{
    const PassScope scope(timer, "frame_view");
    glUseProgram(frameView.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_UNIFORM_BARRIER_BIT);
}

void Renderer::Impl::drawShadowMap()
{
    {
        const PassScope scope(timer, "sphere_list");
        spheres.list();
    }
    const PassScope scope(timer, "shadow map");
    targets.shadowMap.bind();
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    solids.drawShadow();
    spheres.drawShadow();
}

void Renderer::Impl::drawGeometry()
{
    const PassScope scope(timer, "geometry");
    targets.geometry.bind();
    const GLuint nothing[4] = {0, 0, 0, 0};
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    solids.draw();
    spheres.draw();
    glDisable(GL_DEPTH_TEST);
}

void Renderer::Impl::drawOcclusion()
{
    const GLuint nothing[4] = {0, 0, 0, 0};
    targets.depth.bind(DEPTH_UNIT);
    targets.surface.bind(SURFACE_UNIT);
    targets.shadow.bind(SHADOW_UNIT);
    targets.occlusion.bind();
    glClearBufferuiv(GL_COLOR, 0, nothing);
    fullScreen("occlusion", targets.occlusion, occlusion);
}

void Renderer::Impl::drawPicture()
{
    targets.shade.bind(SHADE_UNIT);
    fullScreen("lighting", targets.lighting, lighting);
    targets.picture.bind(PICTURE_UNIT);
    smoothEdges();
    if (settings.antialiasing == 1) return;
    targets.smoothed.bind(PICTURE_UNIT);
    glProgramUniform1i(resolve.id(), 0, static_cast<GLint>(settings.antialiasing));
    fullScreen("resolve", targets.resolve, resolve);
}

void Renderer::Impl::smoothEdges()
{
    const PassScope scope(timer, "edge_filter");
    // What the filter leaves alone must be there already.
    glCopyImageSubData(targets.picture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, targets.smoothed.id(), GL_TEXTURE_2D, 0, 0,
                       0, 0, static_cast<GLsizei>(input.width), static_cast<GLsizei>(input.height), 1);
    targets.edges.bind();
    glUseProgram(edgeFilter.id());
    glBindVertexArray(emptyArray);
    const uint32_t tiles = ((input.width + EDGE_TILE - 1) / EDGE_TILE) * ((input.height + EDGE_TILE - 1) / EDGE_TILE);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(tiles));
}

void Renderer::Impl::fullScreen(const char* name, const Framebuffer& target, const Program& program)
{
    const PassScope scope(timer, name);
    target.bind();
    glUseProgram(program.id());
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Workload drawingWorkload(const RenderSettings& settings)
{
    // The passes of a plain picture, of which a pixel takes 0.11 us on one core of 2.6 GHz.
    const double samples = static_cast<double>(settings.antialiasing) * settings.antialiasing;
    return {8.0, 1.1e-4 * settings.width * settings.height * samples};
}

Renderer::Renderer(Gpu& gpu, const World& world, const RenderSettings& settings)
    : impl_(std::make_unique<Impl>(gpu, world, settings))
{
}

Renderer::~Renderer() = default;

void Renderer::draw(const ParticleView& view, double time)
{
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_DEPTH_CLAMP);
    glDisable(GL_BLEND);
    impl_->attach(view);
    impl_->aimCamera(time);
    impl_->fitView();
    impl_->drawShadowMap();
    impl_->drawGeometry();
    impl_->drawOcclusion();
    impl_->drawPicture();
    const bool resolved = impl_->settings.antialiasing > 1;
    impl_->reader.start((resolved ? impl_->targets.resolve : impl_->targets.edges).id());
}

void Renderer::look(const ParticleView& view, double time)
{
    impl_->attach(view);
    impl_->aimCamera(time);
}

Image Renderer::readImage()
{
    return impl_->reader.last();
}

KernelTimer& Renderer::timer()
{
    return impl_->timer;
}

}  // namespace knuckle
