#include "render/panes/pane.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/frame_input.h"
#include "render/looks/finishes.h"
#include "render/looks/picture_defines.h"
#include "render/marks/joint_marks.h"
#include "render/panes/pane_impl.h"
#include "render/unseen.h"
#include "sim/base/errors.h"

namespace knuckle {

Pane::Impl::Impl(Gpu& gpu, const World& world, const RenderSettings& chosen, KernelTimer& timerIn)
    : settings((checkSettings(chosen), checkTransparency(world, chosen), chosen)), extent(sceneExtent(world)),
      shots(shotsOf(settings)), cameras(camerasOf(shots, world, float(settings.width) / float(settings.height))),
      framed(framedSets(shots, world)), input(frameInput(world, settings, extent)),
      beads(drawsFluids(world, settings, DrawnAs::Particles)),
      unseen("unseenParticles", std::span<const uint32_t>(unseenBits(world))),
      framedParticles("framedParticles", std::span<const uint32_t>(framed.words)), obstacles(world), shown(world),
      targets(settings, {drawsFluids(world, settings, DrawnAs::Surface), fluidsEmit(world, settings),
                         hasGlass(world) && !settings.layers}),
      view(gpu, addInputs(), !world.unseen.empty(), !framed.words.empty(), obstacles.solidCount() > 0),
      quantities(gpu, table, world, settings), fluidLooks(table, world, settings),
      looks(table, world, settings, extent), lists(gpu, table, world, targets.hasSurfaces()),
      colliders(gpu, table, world, settings, extent, targets), skins(gpu, table, world, targets),
      shapes(gpu, table, world, settings, targets), surfaces(gpu, table, world, settings, targets),
      ropes(gpu, table, world, settings, targets), spheres(gpu, table, world, settings, targets),
      fluids(gpu, table, world, settings, targets),
      picture(gpu, table, targets, settings, looks.lighting(), looks.isMirror()), lens(gpu, table, targets, settings),
      marks(gpu, table, settings.markJoints ? jointMarks(world, settings.legend) : Marks(), targets,
            displayDefines(settings)),
      reader(settings.width, settings.height, settings.background == Background::Transparent, settings.depth),
      timer(timerIn)
{
    if (settings.layers) layers.emplace(gpu, table, targets);
    input.cameraPlaneCount = obstacles.planeCount();
    input.cameraSolidCount = obstacles.solidCount();
    gpu.checkErrors();
}

BufferTable& Pane::Impl::addInputs()
{
    targets.addTo(table);
    table.add(Lifetime::Scratch, inputBuffer);
    table.add(Lifetime::Constant, unseen, framedParticles);
    obstacles.addTo(table);
    shown.addTo(table);
    return table;
}

void Pane::Impl::attach(const ParticleView& drawn)
{
    if (drawn.particleCount != input.particleCount)
        throw RunError(fmt::format("the renderer was made for {} particles, and the solver has {}", input.particleCount,
                                   drawn.particleCount));
    describeParticles(input, drawn, targets.hasSurfaces());
    shown.attach(drawn);
    quantities.attach(drawn);
    // The solver's last step wrote the inputs of everything below.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void Pane::Impl::aimCamera(double time, uint32_t draw)
{
    const size_t shot = shotAt(shots, time);
    // A camera that has been cut to sees for the first time.
    const bool goesOn = lookedAt && shotAt(shots, *lookedAt) == shot;
    const float passed = goesOn ? static_cast<float>(std::max(0.0, time - *lookedAt)) : -1.0f;
    lookedAt = time;
    const CameraAim aim = cameras[shot].at(time);
    placeCamera(input, cameras[shot], aim, passed);
    placeLens(input, settings, aim, draw);
    input.framedBit = framed.bits[shot];
    input.focusBit = framed.sharp[shot];
    inputBuffer.upload({&input, 1});
    // The draws of one moment see the same.
    if (passed != 0.0f || draw == 0) view.aim(timer);
    view.fit(timer);
}

void Pane::Impl::drawSurfaces(bool withSkins, bool withParticles)
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
    drawGeometry(withSkins, withParticles);
    picture.drawOcclusion(timer);
}

void Pane::Impl::drawGeometry(bool withSkins, bool withParticles)
{
    targets.geometry.clear();
    colliders.draw(timer);
    if (withSkins) skins.draw(timer);
    if (withParticles) {
        shapes.draw(timer);
        surfaces.draw(timer);
        ropes.draw(timer);
    }
    if (withParticles && input.solidCount > 0) spheres.draw(timer, lists, SphereGroup::Solid);
    if (withParticles && beads) spheres.draw(timer, lists, SphereGroup::Fluid);
}

void Pane::Impl::drawOver(FluidSide side)
{
    picture.drawMirror(timer, side);
    if (!targets.hasGlass()) return;
    targets.smoothed.copy(targets.lit);
    colliders.drawGlass(timer, side);
    shapes.drawGlass(timer, side);
    targets.lit.copy(targets.smoothed);
}

void Pane::Impl::drawOnce()
{
    const bool veiled = settings.skinOpacity < 1.0f && !skins.empty();
    quantities.update(timer);
    lists.update(timer);
    skins.update(timer);
    surfaces.update(timer);
    ropes.update(timer);
    drawSurfaces(!veiled, true);
    picture.drawLighting(timer);
    if (targets.hasGlass()) targets.glass.clear();
    if (!fluids.empty()) {
        fluids.drawDepth(timer, lists);
        drawOver(FluidSide::Behind);
        fluids.shade(timer, shown.foamCount());
    }
    drawOver(FluidSide::InFront);
    if (veiled) {
        drawSurfaces(true, false);
        picture.drawVeil(timer);
    }
    marks.draw(timer);
    picture.drawSmooth(timer);
}

void Pane::Impl::expose(double time, uint32_t first, uint32_t count)
{
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_DEPTH_CLAMP);
    if (first == 0 && !lens.empty()) lens.begin();
    for (uint32_t draw = first; draw < first + count; ++draw) {
        aimCamera(time, draw);
        drawOnce();
        if (!lens.empty()) lens.expose(timer);
    }
    if (first + count < drawsOf(settings)) return;
    if (!lens.empty()) lens.develop(timer);
    reader.start(lens.empty() ? picture.result().id() : lens.result().id());
}

float Pane::Impl::pixelsPerMetre() const
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

Pane::Pane(Gpu& gpu, const World& world, const RenderSettings& settings, KernelTimer& timer)
    : impl_(std::make_unique<Impl>(gpu, world, settings, timer))
{
}

Pane::~Pane() = default;

void Pane::draw(const ParticleView& view, double time)
{
    impl_->attach(view);
    impl_->expose(time, 0, drawsOf(impl_->settings));
}

void Pane::expose(const ParticleView& view, double time, uint32_t draw)
{
    impl_->attach(view);
    impl_->expose(time, draw, 1);
}

void Pane::look(const ParticleView& view, double time)
{
    impl_->attach(view);
    impl_->aimCamera(time, 0);
}

void Pane::setCamera(const Vector3f& position, const Vector3f& target)
{
    for (Camera& camera : impl_->cameras) camera.stand(position, target);
    std::ranges::fill(impl_->framed.bits, 0u);
    std::ranges::fill(impl_->framed.sharp, 0u);
}

LayerCamera Pane::camera() const
{
    return layerCamera(impl_->view.read(), impl_->input.tanHalfFov, impl_->settings.height);
}

Image Pane::readImage()
{
    return impl_->reader.last();
}

float Pane::pixelsPerMetre() const
{
    return impl_->pixelsPerMetre();
}

RendererState Pane::saveState() const
{
    return {impl_->lookedAt, impl_->table.saveState()};
}

void Pane::loadState(const RendererState& state)
{
    impl_->table.loadState(state.buffers);
    impl_->lookedAt = state.lookedAt;
}

}  // namespace knuckle
