#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/colliders/collider_pass.h"
#include "render/fluids/fluid_looks.h"
#include "render/fluids/fluid_pass.h"
#include "render/frame_input.h"
#include "render/looks/picture_looks.h"
#include "render/marks/joint_marks.h"
#include "render/marks/mark_pass.h"
#include "render/overlay/overlay.h"
#include "render/picture/picture_passes.h"
#include "render/picture/picture_reader.h"
#include "render/quantities/quantity_pass.h"
#include "render/ropes/rope_pass.h"
#include "render/shapes/shape_pass.h"
#include "render/skins/skin_pass.h"
#include "render/spheres/sphere_pass.h"
#include "render/surfaces/surface_pass.h"
#include "render/unseen.h"
#include "render/view/framed_sets.h"
#include "render/view/view_passes.h"
#include "sim/base/errors.h"
#include "sim/solver/strand/strand_order.h"

namespace knuckle {

namespace {

void checkTransparency(const World& world, const RenderSettings& settings)
{
    if (settings.background != Background::Transparent) return;
    if (settings.markJoints || drawsFluids(world, settings, DrawnAs::Surface))
        throw InputError(
            "render.background: \"transparent\" is not drawn with surfaces of fluids, nor with marks of joints; draw "
            "fluids as \"particles\", or take \"sky\" or a colour");
}

}  // namespace

/// Members are in the order of their dependencies: each pass finds its inputs in the table when it is made.
struct Renderer::Impl {
    Impl(Gpu& gpu, const World& world, const RenderSettings& chosen);
    BufferTable& addInputs();  ///< Adds to the table, which it returns.
    void attach(const ParticleView& view);
    /// @param time of the film [s].
    void aimCamera(double time);
    /// Draws what casts shadows and what is visible, with the light that reaches it.
    void drawSurfaces(bool withSkins, bool withParticles);
    void draw();
    /// At the depth of what the camera aims at; waits for the frame.
    float pixelsPerMetre() const;

    RenderSettings settings;
    SceneExtent extent;
    std::vector<Shot> shots;
    std::vector<Camera> cameras;  ///< Of the shots.
    FramedSets framed;            ///< Of the same.
    gpu::FrameInput input;
    bool beads;                      ///< Whether fluids are drawn as spheres.
    std::optional<double> lookedAt;  ///< Time of the film at the camera's last look [s].
    Buffer<gpu::FrameInput> inputBuffer{"frame", 1};
    Buffer<uint32_t> unseen, framedParticles;
    Buffer<gpu::vec4> planes;
    RawBuffer positions, velocities, bodyCentres, bodyRotations, colliderPlaces;  ///< Stand in for the view's.
    RawBuffer foamPlaces;                                                         ///< The same.
    uint32_t foamCount = 0;
    Buffer<gpu::vec4> wholeDistances;  ///< Where a view has none of its own.
    RawBuffer distanceStates;          ///< Stands in for the view's.
    RenderTargets targets;
    BufferTable table;
    ViewPasses view;
    QuantityPass quantities;
    FluidLooks fluidLooks;
    PictureLooks looks;
    SphereLists lists;
    ColliderPass colliders;
    SkinPass skins;
    ShapePass shapes;
    SurfacePass surfaces;
    RopePass ropes;
    SpherePass spheres;
    FluidPass fluids;
    PicturePasses picture;
    MarkPass marks;
    PictureReader reader;
    Overlay overlay;
    KernelTimer timer;
};

Renderer::Impl::Impl(Gpu& gpu, const World& world, const RenderSettings& chosen)
    : settings((checkSettings(chosen), checkTransparency(world, chosen), chosen)), extent(sceneExtent(world)),
      shots(shotsOf(settings)), cameras(camerasOf(shots, world, float(settings.width) / float(settings.height))),
      framed(framedSets(shots, world)), input(frameInput(world, settings, extent)),
      beads(drawsFluids(world, settings, DrawnAs::Particles)),
      unseen("unseenParticles", std::span<const uint32_t>(unseenBits(world))),
      framedParticles("framedParticles", std::span<const uint32_t>(framed.words)),
      planes("cameraPlanes", std::span<const gpu::vec4>(cameraPlanes(world))),
      wholeDistances("wholeDistances", canTear(world) ? strandOrder(world).nodeCount : 0),
      targets(settings.width, settings.height, settings.antialiasing, drawsFluids(world, settings, DrawnAs::Surface),
              settings.background == Background::Transparent, settings.depth),
      view(gpu, addInputs(), !world.unseen.empty(), !framed.words.empty()), quantities(gpu, table, world, settings),
      fluidLooks(table, world, settings), looks(table, world, settings, extent),
      lists(gpu, table, world, targets.hasSurfaces()), colliders(gpu, table, world, extent, targets),
      skins(gpu, table, world, targets), shapes(gpu, table, world, settings, targets),
      surfaces(gpu, table, world, settings, targets), ropes(gpu, table, world, settings, targets),
      spheres(gpu, table, world, settings, targets), fluids(gpu, table, world, settings, targets),
      picture(gpu, table, targets, settings, looks.lighting(), looks.isMirror()),
      marks(gpu, table, settings.markJoints ? jointMarks(world, settings.legend) : Marks(), targets),
      reader(settings.width, settings.height, settings.background == Background::Transparent, settings.depth),
      overlay(world, settings)
{
    input.cameraPlaneCount = static_cast<uint32_t>(planes.size());
    gpu.checkErrors();
}

BufferTable& Renderer::Impl::addInputs()
{
    targets.addTo(table);
    table.add(Lifetime::Scratch, inputBuffer);
    table.add(Lifetime::Constant, unseen, framedParticles, planes);
    table.add("positions", positions, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("velocities", velocities, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("bodyCentres", bodyCentres, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("bodyRotations", bodyRotations, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("colliderPlaces", colliderPlaces, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("foamPlaces", foamPlaces, elementType<gpu::vec4>(), Lifetime::Scratch);
    table.add("distanceStates", distanceStates, elementType<gpu::vec4>(), Lifetime::Scratch);
    return table;
}

void Renderer::Impl::attach(const ParticleView& shown)
{
    if (shown.particleCount != input.particleCount)
        throw RunError(fmt::format("the renderer was made for {} particles, and the solver has {}", input.particleCount,
                                   shown.particleCount));
    describeParticles(input, shown, targets.hasSurfaces());
    // Needed even for equal names: the solver may have enlarged a buffer and got its old name again.
    positions = RawBuffer::standIn("positions", shown.positions, shown.particleCount * sizeof(gpu::vec4));
    velocities = RawBuffer::standIn("velocities", shown.velocities, shown.particleCount * sizeof(gpu::vec4));
    bodyCentres = RawBuffer::standIn("bodyCentres", shown.bodyCentres, shown.bodyCount * sizeof(gpu::vec4));
    bodyRotations = RawBuffer::standIn("bodyRotations", shown.bodyRotations, shown.bodyCount * sizeof(gpu::vec4));
    colliderPlaces = RawBuffer::standIn("colliderPlaces", shown.colliderPlaces,
                                        size_t{2} * shown.colliderCount * sizeof(gpu::vec4));
    foamCount = shown.foamCount;
    foamPlaces = RawBuffer::standIn("foamPlaces", shown.foamPlaces, foamCount * sizeof(gpu::vec4));
    const bool tears = shown.distanceStates != 0;
    distanceStates = RawBuffer::standIn("distanceStates", tears ? shown.distanceStates : wholeDistances.id(),
                                        (tears ? shown.distanceCount : wholeDistances.size()) * sizeof(gpu::vec4));
    quantities.attach(shown);
    // The solver's last step wrote the inputs of everything below.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Renderer::Impl::aimCamera(double time)
{
    const size_t shot = shotAt(shots, time);
    // A camera that has been cut to sees for the first time.
    const bool goesOn = lookedAt && shotAt(shots, *lookedAt) == shot;
    const float passed = goesOn ? static_cast<float>(std::max(0.0, time - *lookedAt)) : -1.0f;
    lookedAt = time;
    placeCamera(input, cameras[shot], time, passed);
    input.framedBit = framed.bits[shot];
    inputBuffer.upload({&input, 1});
    view.aim(timer);
}

void Renderer::Impl::drawSurfaces(bool withSkins, bool withParticles)
{
    const bool hasSolids = withParticles && input.solidCount > 0;
    const bool hasFluids = withParticles && beads;
    targets.shadowMap.clear();
    colliders.drawShadow(timer);
    if (withSkins) skins.drawShadow(timer);
    if (withParticles) {
        shapes.drawShadow(timer);
        surfaces.drawShadow(timer);
        ropes.drawShadow(timer);
    }
    if (hasSolids) spheres.drawShadow(timer, lists, SphereGroup::Solid);
    if (hasFluids) spheres.drawShadow(timer, lists, SphereGroup::Fluid);
    if (withParticles && !fluids.empty()) fluids.drawShadow(timer, lists);

    targets.geometry.clear();
    colliders.draw(timer);
    if (withSkins) skins.draw(timer);
    if (withParticles) {
        shapes.draw(timer);
        surfaces.draw(timer);
        ropes.draw(timer);
    }
    if (hasSolids) spheres.draw(timer, lists, SphereGroup::Solid);
    if (hasFluids) spheres.draw(timer, lists, SphereGroup::Fluid);

    picture.drawOcclusion(timer);
}

void Renderer::Impl::draw()
{
    const bool veiled = settings.skinOpacity < 1.0f && !skins.empty();
    view.fit(timer);
    quantities.update(timer);
    lists.update(timer);
    skins.update(timer);
    surfaces.update(timer);
    ropes.update(timer);
    drawSurfaces(!veiled, true);
    picture.drawLighting(timer);
    if (!fluids.empty()) fluids.draw(timer, lists, foamCount);
    if (veiled) {
        drawSurfaces(true, false);
        picture.drawVeil(timer);
    }
    marks.draw(timer);
    picture.drawSmooth(timer);
    reader.start(picture.result().id());
}

float Renderer::Impl::pixelsPerMetre() const
{
    const gpu::FrameView seen = view.read();
    const auto placeOf = [](const gpu::vec4& v) { return Vector3f(v.x, v.y, v.z); };
    const Vector3f low = placeOf(seen.trackedLow), high = placeOf(seen.trackedHigh);
    Vector3f target = placeOf(input.cameraTarget);
    if (input.cameraMode == CAMERA_FOLLOWS) target = low;
    if (input.cameraMode == CAMERA_LOOKS) target = 0.5f * (low + high);
    if (input.cameraMode == CAMERA_FRAMES || input.cameraMode == CAMERA_FRAMES_AROUND)
        target = input.framedBit != 0 ? low : Vector3f(0.5f * (low + high));
    const float depth = (placeOf(seen.cameraPosition) - target).dot(placeOf(seen.cameraBack));
    return static_cast<float>(settings.height) / (2.0f * input.tanHalfFov * depth);
}

Workload drawingWorkload(const RenderSettings& settings)
{
    // The passes of a simple picture; a pixel of it takes 0.11 us on one core of 2.6 GHz.
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
    impl_->attach(view);
    impl_->aimCamera(time);
    impl_->draw();
}

void Renderer::look(const ParticleView& view, double time)
{
    impl_->attach(view);
    impl_->aimCamera(time);
    impl_->view.fit(impl_->timer);  // then what is carried on does not tell whether the frame was drawn
}

Image Renderer::readImage()
{
    Image image = impl_->reader.last();
    if (impl_->overlay.empty()) return image;
    const float scale = impl_->overlay.hasScaleBar() ? impl_->pixelsPerMetre() : 0.0f;
    impl_->overlay.draw(image, impl_->lookedAt.value_or(0.0), scale);
    return image;
}

RendererState Renderer::saveState() const
{
    return {impl_->lookedAt, impl_->table.saveState()};
}

void Renderer::loadState(const RendererState& state)
{
    impl_->table.loadState(state.buffers);
    impl_->lookedAt = state.lookedAt;
}

KernelTimer& Renderer::timer()
{
    return impl_->timer;
}

}  // namespace knuckle
