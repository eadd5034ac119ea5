#pragma once

#include "shared/drive_types.h"
#include "sim/solver/measure/state.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// Puppets (World::puppets): springs pull bodies to where their clips have them, at joints and as pins. They are
/// implicit: each is a torque or a force on bodies through rows of the channel, computed in each iteration from where
/// the bodies are, and a stiffness that joint_factor adds to the block of its joint (driveStiffness).
///
///     animate --> clipBodyTurns, clipBodyPlaces --> drive_joint, drive_pin --> rows --> jointed_solve --> bodyLoads
///     drive_strength --> driveLevels ----------------^          +--> driveStiffness --> joint_factor
class DriveStage : public Stage {
public:
    static bool isNeeded(const World& world) { return !world.puppets.empty(); }
    explicit DriveStage(const StageSetup& setup);
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    /// Before the rest of a substep: what is caught begins to be driven, or is animated again.
    void catchAgain(Recorder& recorder) const;
    /// At its end: blows reduce strengths.
    void end(Recorder& recorder) const;
    /// After animate(): prepares the springs for a substep.
    void begin(Recorder& recorder) const;
    /// Computes the springs' pull for where the bodies are now; before joints are factored, and in each iteration.
    void pull(Recorder& recorder) const;

    /// Measures forces of pins and the states of puppets. Stalls until the GPU is done.
    void measure(Measures& out) const;

    Buffer<gpu::Puppet> puppets;  ///< Its bodies, the keys of its strength.
    Buffer<gpu::JointDrive> jointDrives;
    Buffer<gpu::Pin> pins;
    Buffer<gpu::vec4> strengthKeys;     ///< Per puppet: time [s], strength; 1: smooth.
    Buffer<gpu::uvec2> puppetOrder;     ///< Animated bodies, parents before what hangs on them; 1: pinned.
    Buffer<gpu::uvec2> caughtReleases;  ///< Per animated body: its place in bodyReleases, and when it is let go again.
    Buffer<gpu::uvec4> limpSubsteps;    ///< Per animated body: substep in which it goes limp; the same after it was
                                        ///< caught; when it is caught.
    Buffer<gpu::uvec4> puppetStates;    ///< Per puppet: whether it is caught or knocked out, and where its clips are
                                        ///< put.
    Buffer<gpu::vec4> catchOffsets;     ///< Per animated body: how it differed from its clip when it was caught.
    Buffer<gpu::vec4> driveHits;        ///< Per animated body: strength that a blow has taken, and time since then [s].
    Buffer<float> driveLevels;          ///< Per animated body: the strength of its joint's drive and its pin.
    Buffer<gpu::vec4> composites;       ///< Per animated body with all that hangs on it: centre, mass; inertia.
    Buffer<gpu::vec4> carried;          ///< The same, without what is pinned itself.
    Buffer<gpu::vec4> driveInertias;    ///< Per animated body: inertias that its drive and its pin turn [kg m2]; mass
                                        ///< that its pin moves.
    Buffer<gpu::vec4> driveStates;      ///< Per driven joint: its distance from its clip, its clip, the change.
    Buffer<gpu::vec4> pinStates;        ///< The same per pin, for place and direction.
    Buffer<gpu::vec4> pinsGiven;        ///< Per pin: force [N]; torque [N m]; impulse since the start [N s], work [J].

private:
    const gpu::StepParameters& parameters_;
    bool catches_, hits_;
    Pass catch_{*this, "drive/drive_catch", {}, catches_};
    Pass hit_{*this, "drive/drive_hit", {}, hits_};
    Pass strength_{*this, "drive/drive_strength"};
    Pass inertia_{*this, "drive/drive_inertia"};
    Pass beginJoints_{*this, "drive/drive_joint_begin"};
    Pass beginPins_{*this, "drive/drive_pin_begin"};
    Pass pullJoints_{*this, "drive/drive_joint"};
    Pass pullPins_{*this, "drive/drive_pin"};
};

}  // namespace knuckle
