#include "sim/solver/drive/drive_stage.h"

#include <algorithm>
#include <cmath>

#include "sim/solver/drive/drive_upload.h"

namespace knuckle {

DriveStage::DriveStage(const StageSetup& setup)
    : parameters_(setup.parameters),
      catches_(std::ranges::any_of(setup.world.puppets, [](const Puppet& p) { return p.caught.has_value(); })),
      hits_(std::ranges::any_of(setup.world.puppets, [](const Puppet& p) { return std::isfinite(p.hit.impulse); }))
{
}

void DriveStage::upload(const StageSetup& setup)
{
    const DriveUpload out = driveUpload(setup);
    const size_t bodies = out.limp.size();
    setup.parameters.puppetCount = static_cast<uint32_t>(out.puppets.size());
    setup.parameters.jointDriveCount = static_cast<uint32_t>(out.drives.size());
    setup.parameters.pinCount = static_cast<uint32_t>(out.pins.size());
    puppets = {"puppets", std::span<const gpu::Puppet>(out.puppets)};
    jointDrives = {"jointDrives", std::span<const gpu::JointDrive>(out.drives)};
    pins = {"pins", std::span<const gpu::Pin>(out.pins)};
    strengthKeys = {"strengthKeys", std::span<const gpu::vec4>(out.keys)};
    puppetOrder = {"puppetOrder", std::span<const gpu::uvec2>(out.order)};
    limpSubsteps = {"limpSubsteps", std::span<const gpu::uvec4>(out.limp)};
    caughtReleases = {"caughtReleases", std::span<const gpu::uvec2>(out.again)};
    driveLevels = {"driveLevels", bodies};
    driveHits = {"driveHits", bodies};
    catchOffsets = {"catchOffsets", 2 * bodies};
    puppetStates = {"puppetStates", 2 * out.puppets.size()};
    composites = {"composites", 3 * bodies};
    carried = {"carried", 3 * bodies};
    driveInertias = {"driveInertias", 4 * bodies};
    driveStates = {"driveStates", std::span<const gpu::vec4>(out.driveStates)};
    pinStates = {"pinStates", std::span<const gpu::vec4>(out.pinStates)};
    pinsGiven = {"pinsGiven", PIN_GIVEN_TEXELS * out.pins.size()};
    for (RawBuffer* buffer :
         std::initializer_list<RawBuffer*>{&driveLevels, &driveHits, &catchOffsets, &puppetStates, &pinsGiven})
        buffer->clear();
}

void DriveStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, puppets, jointDrives, pins, strengthKeys, puppetOrder, caughtReleases);
    table.add(Lifetime::Scratch, composites, carried, driveInertias);
    table.add(Lifetime::State, limpSubsteps, driveStates, pinStates, pinsGiven, driveLevels, driveHits, catchOffsets,
              puppetStates);
}

void DriveStage::measure(Measures& out) const
{
    Vector3f impulse(0, 0, 0);
    const std::vector<gpu::vec4> given = pinsGiven.download();
    for (size_t p = 0; p < given.size(); p += PIN_GIVEN_TEXELS) {
        const gpu::vec4 &force = given[p], &torque = given[p + 1], &sum = given[p + 2];
        out.pinForce = std::max(out.pinForce, Vector3f(force.x, force.y, force.z).norm());
        out.pinTorque = std::max(out.pinTorque, Vector3f(torque.x, torque.y, torque.z).norm());
        impulse += Vector3f(sum.x, sum.y, sum.z);
        out.pinWork += sum.w;
    }
    out.pinImpulse = impulse.norm();
    const std::vector<gpu::uvec4> states = puppetStates.download();
    for (size_t p = 0; p < states.size(); p += 2) {
        out.caughtCount += states[p].x == PUPPET_CAUGHT ? 1 : 0;
        out.knockedOutCount += states[p].z;
    }
}

void DriveStage::catchAgain(Recorder& recorder) const
{
    if (catches_) recorder.perElement(catch_, parameters_.puppetCount);
}

void DriveStage::end(Recorder& recorder) const
{
    if (hits_) recorder.perElement(hit_, parameters_.animatedCount);
}

void DriveStage::begin(Recorder& recorder) const
{
    recorder.perElement(strength_, parameters_.puppetCount);
    recorder.perElement(inertia_, parameters_.puppetCount);
    recorder.perElement(beginJoints_, parameters_.jointDriveCount);
    recorder.perElement(beginPins_, parameters_.pinCount);
}

void DriveStage::pull(Recorder& recorder) const
{
    recorder.perElement(pullJoints_, parameters_.jointDriveCount);
    recorder.perElement(pullPins_, parameters_.pinCount);
}

}  // namespace knuckle
