#pragma once

#include <vector>

#include "shared/drive_types.h"
#include "sim/solver/stage.h"

namespace knuckle {

/// The initial contents of DriveStage's buffers.
struct DriveUpload {
    std::vector<gpu::Puppet> puppets;
    std::vector<gpu::JointDrive> drives;
    std::vector<gpu::Pin> pins;
    std::vector<gpu::vec4> keys, driveStates, pinStates;
    std::vector<gpu::uvec2> order, again;  ///< Per animated body.
    std::vector<gpu::uvec4> limp;          ///< Per animated body.
};

DriveUpload driveUpload(const StageSetup& setup);

/// Reserves rows of the channel: two for each driven joint, one for each pin.
void reserveDriveRows(RowPlan& rows, const World& world);

}  // namespace knuckle
