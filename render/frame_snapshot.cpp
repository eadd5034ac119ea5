#include "render/frame_snapshot.h"

#include <algorithm>

#include "render/quantities/color_scale.h"
#include "render/view/framed_sets.h"
#include "shared/gpu_types.h"

namespace knuckle {

namespace {

/// Copies into `copy`, which is made on first use. @returns its name.
GLuint copyBytes(GLuint source, size_t bytes, RawBuffer& copy, const char* label)
{
    if (copy.id() == 0) copy = RawBuffer(label, bytes);
    glBindBuffer(GL_COPY_READ_BUFFER, source);
    glBindBuffer(GL_COPY_WRITE_BUFFER, copy.id());
    if (bytes > 0) glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(bytes));
    return copy.id();
}

GLuint copyVectors(GLuint source, uint32_t count, RawBuffer& copy, const char* label)
{
    return copyBytes(source, count * sizeof(gpu::vec4), copy, label);
}

/// Whether any camera goes by the middle of an object.
bool follows(const RenderSettings& picture)
{
    return std::ranges::any_of(shotsOf(picture), [](const Shot& shot) {
        return shot.camera.kind == CameraKind::Follow || shot.other.kind == CameraKind::Follow;
    });
}

}  // namespace

FrameSnapshot::Fence::~Fence()
{
    glDeleteSync(sync_);
}

void FrameSnapshot::Fence::set()
{
    glDeleteSync(sync_);
    sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    // Otherwise the other context might wait for commands that were never sent.
    glFlush();
}

void FrameSnapshot::Fence::wait()
{
    if (sync_ != nullptr) glWaitSync(sync_, 0, GL_TIMEOUT_IGNORED);
}

FrameSnapshot::FrameSnapshot(const World& world, const std::vector<RenderSettings>& pictures)
    : showsSpeeds_(std::ranges::any_of(pictures, [](const auto& p) { return p.colorBy == ColorBy::Speed; })),
      showsRotations_(!world.skins.empty() || !world.bodyShapes.empty()),
      showsCentres_(showsRotations_ || std::ranges::any_of(pictures, follows)),
      showsSlots_(world.fluidCount > 0 && std::ranges::any_of(pictures, showsFluids))
{
}

void FrameSnapshot::take(const ParticleView& view)
{
    drawn_.wait();
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    view_ = view;
    view_.positions = copyVectors(view.positions, view.particleCount, positions_, "drawn positions");
    const uint32_t speeds = showsSpeeds_ ? view.particleCount : 0;
    const uint32_t centres = showsCentres_ ? view.bodyCount : 0, rotations = showsRotations_ ? view.bodyCount : 0;
    view_.velocities = copyVectors(view.velocities, speeds, velocities_, "drawn velocities");
    view_.bodyCentres = copyVectors(view.bodyCentres, centres, centres_, "drawn centres");
    view_.bodyRotations = copyVectors(view.bodyRotations, rotations, rotations_, "drawn rotations");
    view_.colliderPlaces = copyVectors(view.colliderPlaces, 2 * view.colliderCount, colliders_, "drawn colliders");
    view_.foamPlaces = copyVectors(view.foamPlaces, view.foamCount, foam_, "drawn foam");
    if (view.fluidForms != 0)
        view_.fluidForms = copyBytes(view.fluidForms, view.particleCount * sizeof(uint32_t), forms_, "drawn forms");
    view_.distanceStates = copyVectors(view.distanceStates, view.distanceCount, distances_, "drawn distances");
    if (showsSlots_) takeSlots(view);
    const size_t floats = view.particleCount * sizeof(float);
    if (view.ages != 0) view_.ages = copyBytes(view.ages, floats, ages_, "drawn ages");
    if (view.contactForces != 0)
        view_.contactForces = copyBytes(view.contactForces, floats, contactForces_, "drawn forces");
    taken_.set();
}

void FrameSnapshot::takeSlots(const ParticleView& view)
{
    const uint32_t slots = view.slotPressures != 0 ? view.particleCount : 0;
    view_.particleSlots = copyBytes(view.particleSlots, slots * sizeof(uint32_t), particleSlots_, "drawn slots");
    view_.slotParticles = copyBytes(view.slotParticles, slots * sizeof(uint32_t), slotParticles_, "drawn in slots");
    view_.slotPressures = copyVectors(view.slotPressures, 2 * slots, pressures_, "drawn pressures");
    view_.slotShapes = copyVectors(view.slotShapes, 2 * slots, shapes_, "drawn evenness");
    view_.slotCovers = copyVectors(view.slotCovers, slots, covers_, "drawn densities");
}

const ParticleView& FrameSnapshot::begin()
{
    taken_.wait();
    return view_;
}

void FrameSnapshot::end()
{
    drawn_.set();
}

}  // namespace knuckle
