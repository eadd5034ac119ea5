#pragma once

#include "app/export/exporters.h"
#include "app/states/frame_record.h"

namespace knuckle {

/// Hands a frame to exporters. @throws std::logic_error if the record lacks what they need.
void exportFrame(const FrameRecord& record, const World& world, const ExportNeeds& needs, const Exporters& exporters);

}  // namespace knuckle
